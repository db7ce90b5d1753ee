// SPDX-License-Identifier: BSD-3-Clause
#include "stairs.h"

#include "stair_flights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief Adds flights to the nearest link between the floors that they join, or as a
 * new one. Others between these floors are then edges of the void that it leads
 * through, and go. */
void
addStair(std::vector<PlanFlight>&& flights,
         const std::array<std::uint32_t, 2>& rooms,
         std::vector<PlanStair>& stairs)
{
  constexpr double near = 2; // metres in plan from a link's opening
  const double bottom = flights.front().bottom;
  const double top = flights.back().top();
  const auto distanceOf = [&](const PlanStair& stair) {
    double away = std::numeric_limits<double>::infinity();
    for (const PlanFlight& flight : flights)
      for (std::size_t k = 0; k < flight.steps(); ++k)
        away = std::min(away, (flight.middle(k) - stair.at).norm());
    return away;
  };
  const auto isBeside = [&](const PlanStair& stair) {
    return stair.flights.empty() && std::abs(stair.bottom - bottom) < near / 4 &&
           std::abs(stair.top - top) < near / 4 && distanceOf(stair) < near;
  };
  PlanStair stair{rooms, flights.back().middle(flights.back().steps() - 1), bottom,
                  top};
  double nearest = near;
  for (const PlanStair& link : stairs)
    if (isBeside(link) && distanceOf(link) < nearest) {
      nearest = distanceOf(link);
      stair.rooms = link.rooms;
      stair.at = link.at;
    }
  stairs.erase(std::remove_if(stairs.begin(), stairs.end(), isBeside), stairs.end());
  stair.flights = std::move(flights);
  stairs.push_back(std::move(stair));
}

} // namespace

void
addFlights(const PointView& points,
           const std::vector<int>& indices,
           const VoxelColumns& fine,
           Building& building)
{
  constexpr double widest_cell = 0.1; // metres
  if (fine.cellSize() > widest_cell)
    return;
  const RoomFloors floors(building, fine.voxelHeight());
  const std::vector<LevelPatch> patches = levelPatches(points, indices, fine, floors);
  StairChains chains(patches, floors, fine.cellSize());
  for (std::vector<StairStep> chain = chains.next(); !chain.empty();
       chain = chains.next()) {
    std::vector<PlanFlight> flights = flightsOf(chain, patches, fine.cellSize());
    if (flights.empty())
      continue;
    const RoomFloors::Floor foot = leadToFloor(flights.front(), floors, true);
    const RoomFloors::Floor head = leadToFloor(flights.back(), floors, false);
    if (flights.size() == 1 && foot.room != 0 && head.room != 0)
      fitBetween(foot.z, head.z, flights[0]);
    addStair(std::move(flights), {foot.room, head.room}, building.stairs);
  }
}

} // namespace pcl::sedr
