// SPDX-License-Identifier: BSD-3-Clause
#include "../stairs/stair_priors.h"

#include <pcl/sedr_filters/plan_measures.h>
#include <pcl/sedr_filters/point_types.h>
#include <pcl/sedr_segmentation/building.h>
#include <pcl/sedr_segmentation/impl/room_segmentation.hpp>

#include <pcl/impl/instantiate.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace pcl::sedr {

std::string
problemOf(const BuildingParameters& parameters)
{
  if (!(parameters.minimum_enclosure >= 0 && parameters.minimum_enclosure <= 1))
    return "the minimum enclosure must be within 0 and 1, it is " +
           std::to_string(parameters.minimum_enclosure);
  const std::string problem =
      positiveProblem({{"the grid size", parameters.cell_size},
                       {"the headroom", parameters.headroom},
                       {"the storey step", parameters.storey_step}});
  return problem.empty()
             ? positiveProblem({{"the minimum area", parameters.minimum_area}},
                               "square metres")
             : problem;
}

namespace {

/** @brief Puts the ends of a stair on the floors that were fitted there; its steps are
 * then equal parts of their difference. */
void
standOnFloors(const Floorplan& plan, PlanStair& stair)
{
  const auto floorOf = [&](std::uint32_t id, bool is_foot, double z) {
    const auto& flights = stair.flights;
    const PlanRoom* const room = findRoom(plan, id);
    const double floor =
        !room             ? z
        : flights.empty() ? room->floorAt(stair.at)
        : is_foot         ? room->floorAt(flights.front().middle(0))
                  : room->floorAt(flights.back().middle(flights.back().steps() - 1));
    return std::abs(floor - z) < stair_priors.same_floor ? floor : z;
  };
  const double bottom = floorOf(stair.rooms[0], true, stair.bottom);
  const double top = floorOf(stair.rooms[1], false, stair.top);
  const double height = stair.top - stair.bottom;
  const double scale = height > 0 ? (top - bottom) / height : 1;
  for (PlanFlight& flight : stair.flights) {
    flight.bottom = bottom + scale * (flight.bottom - stair.bottom);
    flight.rise *= scale;
  }
  stair.bottom = bottom;
  stair.top = top;
}

} // namespace

void
giveStoreys(const Building& building, Floorplan& plan)
{
  const auto isKnown = [&](std::uint32_t id) { // 0: a stair's end that nobody saw
    return id == 0 || findRoom(plan, id);
  };
  const auto isKept = [&](const PlanStair& stair) {
    return isKnown(stair.rooms[0]) && isKnown(stair.rooms[1]) && stair.leadsSomewhere();
  };
  plan.storeys = building.storeys;
  plan.storeys = storeysOf(plan); // without the rooms that have no plan
  plan.stairs.clear();
  std::copy_if(building.stairs.begin(), building.stairs.end(),
               std::back_inserter(plan.stairs), isKept);
  for (PlanStair& stair : plan.stairs)
    standOnFloors(plan, stair);
}

std::vector<PlanWarning>
linksWithoutOpening(const Building& building, const Floorplan& plan)
{
  std::vector<PlanWarning> warnings;
  for (const RoomLink& link : building.links) {
    const auto [room, other] = link.rooms;
    const Eigen::Vector2d middle = (link.start + link.end) / 2;
    const auto isOpening = [&, a = room, b = other](const PlanOpening& opening) {
      return std::minmax(opening.rooms[0], opening.rooms[1]) == std::minmax(a, b) &&
             isAt(opening, middle, link.bottom, link.top);
    };
    if (findRoom(plan, room) && findRoom(plan, other) &&
        std::none_of(plan.openings.begin(), plan.openings.end(), isOpening))
      warnings.push_back({WarningKind::NoOpening,
                          {link.width(), link.height(), static_cast<double>(other)},
                          room,
                          0,
                          {},
                          middle});
  }
  return warnings;
}

std::vector<PlanWarning>
doubtsOfRooms(const Building& building, const Floorplan& plan)
{
  std::vector<PlanWarning> warnings;
  for (const RoomDoubt& doubt : building.doubts) {
    const auto [room, other] = doubt.rooms;
    if (!findRoom(plan, room) || !findRoom(plan, other))
      continue;
    PlanWarning warning{WarningKind::TwoRooms, {doubt.area, 100 * doubt.chance}, room};
    if (room != other) {
      warning.kind = WarningKind::OneRoom;
      warning.values.push_back(other);
    }
    warning.at = doubt.at;
    warnings.push_back(std::move(warning));
  }
  return warnings;
}

} // namespace pcl::sedr

PCL_INSTANTIATE(RoomSegmentation, SEDR_POINT_TYPES)
