// SPDX-License-Identifier: BSD-3-Clause
#include "room_shares.h"

#include "../air/height_counts.h"
#include "../faces/room_cells.h"
#include "../niches/niche_fit.h"
#include "room_territory.h"
#include "sedr_filters/src/base/exactness.h"
#include "sedr_filters/src/base/parallel_for.h"

#include <algorithm>
#include <array>
#include <map>
#include <memory>

namespace pcl::sedr {

namespace {

/** @brief Returns the height range of each room, pits included; one without floor
 * points is as high as usual below the lowest of its ceiling.
 * @param pit least area of one, square metres */
std::vector<RoomHeights>
heightsOfRooms(const PointView& points,
               const CellGrid& grid,
               double pit,
               const std::vector<std::vector<int>>& floors,
               const std::vector<std::vector<int>>& ceilings,
               const std::vector<std::vector<int>>& details,
               const std::vector<HiddenCells>& hidden)
{
  std::vector<RoomHeights> heights;
  for (std::size_t r = 0; r < floors.size(); ++r) {
    std::vector<float> above;
    for (const auto* part : {&ceilings[r], &details[r]})
      for (const int i : *part)
        above.push_back(points[static_cast<std::size_t>(i)].z());
    for (const Eigen::Vector3f& place : hidden[r].ceiling)
      above.push_back(place.z());
    double floor = 0;
    HeightCounts lows;
    for (const int i : floors[r])
      if (points.isFinite(static_cast<std::size_t>(i)))
        lows.add(points[static_cast<std::size_t>(i)].z());
    if (!lows.empty())
      floor = lows.lowestOf(
          pit / (static_cast<double>(CellSet(grid, points, floors[r]).size()) *
                 grid.size() * grid.size()));
    else if (!above.empty())
      floor = *std::min_element(above.begin(), above.end()) - usual_height;
    heights.push_back(heightsFrom(floor, std::move(above)));
  }
  return heights;
}

} // namespace

std::vector<std::uint32_t>
roomNumbers(const PlanEvidence& evidence)
{
  if (evidence.room.empty())
    return {1};
  std::vector<std::uint32_t> numbers;
  for (const int i : evidence.ceiling)
    if (evidence.room[static_cast<std::size_t>(i)] != 0)
      numbers.push_back(evidence.room[static_cast<std::size_t>(i)]);
  for (const auto& [number, cells] : evidence.hidden)
    if (!cells.ceiling.empty())
      numbers.push_back(number);
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

std::vector<int>
seenPoints(const PointView& points,
           const CellGrid& grid,
           const std::vector<int>& indices,
           bool is_floor)
{
  // Metres: more than the steepest slope rises in a cell.
  const auto step = static_cast<float>(2 * grid.size());
  const float sign = is_floor ? -1 : 1;
  std::map<CellKey, float> nearest;
  const auto forAll = [&](auto use) {
    for (const int i : indices)
      if (const auto at = static_cast<std::size_t>(i);
          points.isFinite(at) && grid.holds(points[at].x(), points[at].y()))
        use(i, keyOf(grid.at(points[at].x(), points[at].y())), sign * points[at].z());
  };
  forAll([&](int, CellKey cell, float z) {
    const auto known = nearest.emplace(cell, z).first;
    known->second = std::min(known->second, z);
  });
  std::vector<int> seen;
  forAll([&](int i, CellKey cell, float z) {
    if (z < nearest[cell] + step)
      seen.push_back(i);
  });
  return seen;
}

std::vector<RoomEvidence>
shareOut(const PointView& points,
         const PlanEvidence& evidence,
         const std::vector<std::uint32_t>& numbers,
         const RoomFitParameters& parameters,
         std::string& problem)
{
  const Priors& priors = parameters.priors;
  const CellGrid grid(parameters.cell_size);
  const auto labelled = [&](int i) -> std::int32_t {
    const Eigen::Vector3f p = points[static_cast<std::size_t>(i)];
    if (!points.isFinite(static_cast<std::size_t>(i)) || !grid.holds(p.x(), p.y()))
      return -1;
    if (evidence.room.empty())
      return 0;
    const auto number = evidence.room[static_cast<std::size_t>(i)];
    const auto it = std::lower_bound(numbers.begin(), numbers.end(), number);
    return it != numbers.end() && *it == number
               ? static_cast<std::int32_t>(it - numbers.begin())
               : -1;
  };
  const auto shareBy = [&](const std::vector<int>& indices, const auto& roomOf) {
    std::vector<std::int32_t> room_of(indices.size()); // -1: none
    parallelFor(indices.size(), points_a_block, parameters.threads,
                [&](std::size_t k) { room_of[k] = roomOf(indices[k]); });
    std::vector<std::vector<int>> shares(numbers.size());
    for (std::size_t k = 0; k < indices.size(); ++k)
      if (room_of[k] >= 0)
        shares[static_cast<std::size_t>(room_of[k])].push_back(indices[k]);
    return shares;
  };
  auto ceilings = shareBy(evidence.ceiling, labelled);
  auto details = shareBy(evidence.details, labelled);
  std::vector<std::vector<int>> of_sheets(numbers.size());
  for (std::size_t r = 0; r < numbers.size(); ++r) {
    std::vector<int> both = ceilings[r];
    both.insert(both.end(), details[r].begin(), details[r].end());
    of_sheets[r] = seenPoints(points, grid, both, false);
  }
  std::vector<CellSet> scopes;
  std::vector<HiddenCells> hidden;
  for (std::size_t r = 0; r < numbers.size(); ++r) {
    const auto known = evidence.hidden.find(numbers[r]);
    hidden.push_back(known == evidence.hidden.end() ? HiddenCells() : known->second);
    scopes.push_back(unite(
        unite(CellSet(grid, points, ceilings[r]), CellSet(grid, points, details[r])),
        cellsOf(grid, hidden[r].ceiling)));
  }
  const std::vector<RoomHeights> heights =
      heightsOfRooms(points, grid, parameters.minimum_detail_area,
                     shareBy(evidence.floor, labelled), ceilings, details, hidden);
  std::array<std::unique_ptr<const RoomTerritory>, 2> territories;
  parallelBlocks(territories.size(), 1, parameters.threads,
                 [&](std::size_t k, std::size_t) {
                   territories[k] = std::make_unique<RoomTerritory>(
                       grid, scopes, heights,
                       k == 0 ? wallReach(priors) : nicheReach({priors}), priors);
                 });
  const RoomTerritory& territory = *territories[0];
  const RoomTerritory& wide = *territories[1];
  problem = territory.problem().empty() ? wide.problem() : territory.problem();
  if (!problem.empty())
    return {};
  const std::vector<std::int32_t> room_of =
      territory.roomsAt(points, parameters.threads);
  const auto nearest = [&](int i) { return room_of[static_cast<std::size_t>(i)]; };
  auto floors = shareBy(evidence.floor, [&](int i) {
    const std::int32_t room = labelled(i);
    return room < 0 ? nearest(i) : room;
  });
  auto around = shareBy(evidence.all, nearest);
  auto behind = shareBy(evidence.all, [&](int i) {
    return nearest(i) < 0 ? wide.roomAt(points[static_cast<std::size_t>(i)]) : -1;
  });
  auto walls = evidence.walls.empty() ? around : shareBy(evidence.walls, nearest);

  std::vector<RoomEvidence> rooms;
  for (std::size_t r = 0; r < numbers.size(); ++r)
    rooms.push_back({std::move(around[r]), std::move(ceilings[r]),
                     std::move(details[r]), std::move(floors[r]), std::move(walls[r]),
                     std::move(behind[r]), std::move(of_sheets[r]),
                     std::move(hidden[r])});
  return rooms;
}

} // namespace pcl::sedr
