// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_segmentation/plan_fit.h>

#include <pcl/sedr_filters/cell_mask.h>

#include <algorithm>
#include <map>

namespace pcl {
namespace sedr {

namespace {

/** @brief How far from a room's ceiling its walls may be, in cells. */
constexpr int reach_in_cells = 14;

/** @brief Which room is nearest to each cell. */
struct Territory {
  CellMask frame;
  std::vector<std::int32_t> room; ///< index in the list of rooms, -1 none

  /** @brief Room of a point, -1 for none. */
  std::int32_t
  at(const CellGrid& grid, const Eigen::Vector3f& p) const
  {
    if (!std::isfinite(p.z()) || !grid.holds(p.x(), p.y()))
      return -1;
    const Cell cell = grid.at(p.x(), p.y());
    return frame.isInside(cell) ? room[frame.indexOf(cell)] : -1;
  }
};

/** @brief Number of each room, 0 left out; the rooms of their index. */
std::vector<std::uint32_t>
roomNumbers(const PlanEvidence& evidence)
{
  if (evidence.room.empty())
    return {1};
  std::vector<std::uint32_t> numbers;
  for (const int i : evidence.ceiling)
    if (evidence.room[static_cast<std::size_t>(i)] != 0)
      numbers.push_back(evidence.room[static_cast<std::size_t>(i)]);
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

/** @brief Shares out indices by the room that `roomOf(index)` gives, -1 for none. */
template <typename RoomOf>
std::vector<std::vector<int>>
shareOut(const std::vector<int>& indices, std::size_t rooms, RoomOf roomOf)
{
  std::vector<std::vector<int>> shares(rooms);
  for (const int i : indices) {
    const std::int32_t r = roomOf(i);
    if (r >= 0)
      shares[static_cast<std::size_t>(r)].push_back(i);
  }
  return shares;
}

/** @brief Grows the rooms' ceilings and details outwards until they meet. */
Territory
findTerritory(const PointView& points,
              const CellGrid& grid,
              const std::vector<std::vector<int>>& ceilings,
              const std::vector<std::vector<int>>& details,
              std::string& problem)
{
  std::vector<CellSet> scopes;
  CellSet all;
  for (std::size_t r = 0; r < ceilings.size(); ++r) {
    scopes.push_back(
        unite(CellSet(grid, points, ceilings[r]), CellSet(grid, points, details[r])));
    all = unite(all, scopes.back());
  }
  Territory territory;
  const CellBox box = grown(boxOf(all), reach_in_cells + 1);
  problem = maskProblem(box);
  if (!problem.empty())
    return territory;
  territory.frame = inverted(CellMask(box));
  territory.room.assign(territory.frame.values().size(), -1);
  for (std::size_t r = 0; r < scopes.size(); ++r)
    for (std::size_t i = 0; i < scopes[r].size(); ++i) {
      auto& room = territory.room[territory.frame.indexOf(scopes[r][i])];
      room = room < 0 ? static_cast<std::int32_t>(r) : room;
    }
  growLabels(territory.frame, reach_in_cells, territory.room);
  return territory;
}

} // namespace

Floorplan
fitPlan(const PointView& points,
        const PlanEvidence& evidence,
        const RoomFitParameters& parameters,
        std::string& problem,
        std::vector<std::string>& warnings)
{
  Floorplan plan;
  problem.clear();
  warnings.clear();
  const CellGrid grid(parameters.cell_size);
  const std::vector<std::uint32_t> numbers = roomNumbers(evidence);
  const auto labelled = [&](int i) -> std::int32_t {
    if (!points.isFinite(static_cast<std::size_t>(i)))
      return -1;
    if (evidence.room.empty())
      return 0;
    const auto number = evidence.room[static_cast<std::size_t>(i)];
    const auto it = std::lower_bound(numbers.begin(), numbers.end(), number);
    return it != numbers.end() && *it == number ? static_cast<std::int32_t>(it - numbers.begin())
                                                : -1;
  };
  auto ceilings = shareOut(evidence.ceiling, numbers.size(), labelled);
  auto details = shareOut(evidence.details, numbers.size(), labelled);
  const Territory territory = findTerritory(points, grid, ceilings, details, problem);
  if (!problem.empty())
    return plan;
  const auto nearest = [&](int i) {
    return territory.at(grid, points[static_cast<std::size_t>(i)]);
  };
  auto floors = shareOut(evidence.floor, numbers.size(), nearest);
  auto around = shareOut(evidence.all, numbers.size(), nearest);
  auto walls = evidence.walls.empty() ? around : shareOut(evidence.walls, numbers.size(), nearest);

  for (std::size_t r = 0; r < numbers.size(); ++r) {
    std::string reason;
    if (ceilings[r].size() < 3 || floors[r].size() < 3)
      reason = std::to_string(ceilings[r].size()) + " ceiling points and " +
               std::to_string(floors[r].size()) + " floor points are too few, 3 are needed of each";
    PlanRoom room;
    if (reason.empty())
      room = fitRoom(points,
                     {around[r], ceilings[r], details[r], floors[r], walls[r]},
                     parameters,
                     reason);
    room.id = numbers[r];
    if (reason.empty())
      plan.rooms.push_back(std::move(room));
    else
      warnings.push_back("room " + std::to_string(numbers[r]) + ": " + reason);
  }
  if (plan.rooms.empty())
    problem = warnings.empty() ? "no ceiling point belongs to a room" : warnings.front();
  return plan;
}

} // namespace sedr
} // namespace pcl
