// SPDX-License-Identifier: BSD-3-Clause
#include "../base/number_text.h"
#include "../plan/missing_things.h"
#include "plan_edits.h"

#include <pcl/sedr_filters/plan_editor.h>
#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <initializer_list>
#include <memory>
#include <string>
#include <vector>

namespace pcl::sedr {

namespace {

/** @brief Raises a slab by hand. */
void
lift(PlanSlab& slab, double by)
{
  slab.plane[3] -= by * slab.plane[2];
  if (slab.curve)
    slab.curve = std::make_shared<const SlabCurve>(moved(*slab.curve, 0, {0, 0, by}));
  setByHand(slab);
}

/** @brief Raises a floor or ceiling with its slopes. */
void
lift(PlanSlab& slab, std::vector<PlanDetail>& details, double by)
{
  lift(slab, by);
  for (PlanDetail& detail : details)
    if (detail.is_facet)
      lift(detail.slab, by);
}

constexpr const char* no_rise = "a stair would lead nowhere";

/** @brief Raises the ends of stairs that stand on floors that were raised.
 * @param is_moved tells it of a room and a height of its floor
 * @return false if one would then not rise */
bool
moveStairs(Floorplan& plan,
           const std::function<bool(std::uint32_t, double)>& is_moved,
           double by)
{
  for (PlanStair& stair : plan.stairs) {
    const double low = stair.bottom;
    const double old_rise = stair.top - low;
    stair.bottom += is_moved(stair.rooms[0], stair.bottom) ? by : 0;
    stair.top += is_moved(stair.rooms[1], stair.top) ? by : 0;
    const double stretch = (stair.top - stair.bottom) / old_rise;
    if (!(stretch > 0))
      return false;
    for (PlanFlight& flight : stair.flights) {
      flight.bottom = stair.bottom + stretch * (flight.bottom - low);
      flight.rise *= stretch;
    }
  }
  return true;
}

/** @brief Returns where a ceiling would then lie lower below the floor than before, or
 * an empty text. */
std::string
crossingProblem(const PlanRoom& before, const PlanRoom& room)
{
  const ClearHeight clear = clearHeight(room);
  if (clear.least > 0 || clear.least >= clearHeight(before).least)
    return {};
  return formatText("its ceiling would then be %.3f m below its floor at (%.2f, %.2f)",
                    -clear.least, clear.lowest.x(), clear.lowest.y());
}

/** @brief Forgets how well an opening is known, but for its other edges. */
void
forgetEdges(PlanOpening& opening, std::initializer_list<std::size_t> edges)
{
  const auto before = opening.edges;
  opening.forgetAccuracy();
  opening.edges = before;
  for (const std::size_t k : edges)
    opening.edges[k] = {};
}

/** @brief Returns a sentence, "the floor of room 3 is at z 0.100 m, it was at 0.000".
 */
std::string
raisedText(const char* what, std::uint32_t number, double before, double by)
{
  return what + std::to_string(number) +
         formatText(" is at z %.3f m, it was at %.3f", before + by, before);
}

} // namespace

bool
PlanEditor::setFloor(std::uint32_t room, double z)
{
  return apply(room, [&](Floorplan& plan, PlanRoom& of) -> std::string {
    const RoomHeights heights = heightsOf(of);
    if (!(z < heights.high))
      return formatText("its ceiling is at z %.3f m", heights.high);
    constexpr double on_floor = 0.05; // metres
    for (PlanOpening& opening : plan.openings)
      if (std::count(opening.rooms.begin(), opening.rooms.end(), room) > 0 &&
          std::abs(opening.bottom - heights.low) < on_floor) {
        opening.bottom = z;
        forgetEdges(opening, {2});
      }
    const auto isOnIt = [&](std::uint32_t id, double foot) {
      return id == room && std::abs(foot - heights.low) < on_floor;
    };
    if (!moveStairs(plan, isOnIt, z - heights.low))
      return no_rise;
    lift(of.floor, of.floor_details, z - heights.low);
    sentence_ = raisedText("the floor of room ", room, heights.low, z - heights.low);
    return crossingProblem(*findRoom(plan_, room), of);
  });
}

bool
PlanEditor::setCeiling(std::uint32_t room, double z)
{
  return apply(room, [&](Floorplan&, PlanRoom& of) -> std::string {
    const RoomHeights heights = heightsOf(of);
    if (!(z > heights.low))
      return formatText("its floor is at z %.3f m", heights.low);
    lift(of.ceiling, of.details, z - heights.high);
    sentence_ =
        raisedText("the ceiling of room ", room, heights.high, z - heights.high);
    return crossingProblem(*findRoom(plan_, room), of);
  });
}

bool
PlanEditor::setStorey(std::uint32_t number, double z)
{
  return apply([&](Floorplan& plan) -> std::string {
    const std::vector<PlanStorey> storeys = storeysOf(plan);
    const PlanStorey* const storey = findStorey(storeys, number);
    if (!storey)
      return lacksStorey(storeys, number);
    const double floor = usualFloor(plan, *storey);
    const double by = z - floor;
    const auto isOf = [&](std::uint32_t room) {
      return std::count(storey->rooms.begin(), storey->rooms.end(), room) > 0;
    };
    for (PlanRoom& room : plan.rooms) {
      if (!isOf(room.id))
        continue;
      for (PlanSlab* const slab : {&room.floor, &room.ceiling})
        lift(*slab, by);
      for (auto* const details : {&room.floor_details, &room.details})
        for (PlanDetail& detail : *details)
          lift(detail.slab, by);
      for (PlanNiche& niche : room.niches)
        for (PlanSlab* const slab : {&niche.bottom, &niche.top})
          lift(*slab, by);
    }
    for (PlanOpening& opening : plan.openings)
      if (isOf(opening.rooms[opening.rooms[0] == 0 ? 1 : 0])) {
        opening.bottom += by;
        opening.top += by;
        forgetEdges(opening, {2, 3});
      }
    if (!moveStairs(
            plan, [&](auto room, double) { return isOf(room); }, by))
      return no_rise;
    sentence_ = raisedText("the usual floor of storey ", number, floor, by);
    return {};
  });
}

} // namespace pcl::sedr
