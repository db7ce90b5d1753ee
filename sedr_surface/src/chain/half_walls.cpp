// SPDX-License-Identifier: BSD-3-Clause
#include "seen_surfaces.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

void
SeenSurfaces::tellHalfWalls(std::size_t room, std::vector<PlanWarning>& warnings) const
{
  constexpr double low = 0.3;      // metres above the floor, where legs and seats end
  constexpr double high = 0.9;     // likewise of the lowest half wall
  constexpr double shortest = 1;   // metres; leaves of doors are shorter
  constexpr double thickest = 0.3; // metres, with a tile
  constexpr HeightSteps top = 3;
  const RoomLookup& lookup = rooms_[room];
  const auto seenBetween = [&](CellKey key, const OffModel& off) {
    const double height = off.ceiling - lookup.floorAt(tiles_.centre(cellOf(key)));
    std::pair<int, int> steps{0, 0}; // seen, and all
    for (double z = low + wall_tile / 2; z < high; z += wall_tile) {
      steps.first += (off.once & stepAt(height - z, wall_tile)).any() ? 1 : 0;
      ++steps.second;
    }
    return steps;
  };
  const auto isBare = [&](const Eigen::Vector2d& p) {
    const CellKey key = keyOf(tiles_.at(p.x(), p.y()));
    const auto off = off_[room].find(key);
    return isOnSlab(room, keyOf(grid_.at(p.x(), p.y())), true) &&
           (off == off_[room].end() || seenBetween(key, off->second).first == 0);
  };
  const auto hasFloor = [&](const Eigen::Vector2d& at, const Eigen::Vector2d& way) {
    for (double d = wall_tile; d < thickest + wall_tile / 2; d += wall_tile)
      if (isBare(at + d * way) && isBare(at + (d + wall_tile) * way))
        return true; // more than the recess below a counter
    return false;
  };
  const auto isThin = [&](const Eigen::Vector2d& at) {
    for (const Eigen::Vector2d& way : {Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 1),
                                       Eigen::Vector2d(M_SQRT1_2, M_SQRT1_2),
                                       Eigen::Vector2d(M_SQRT1_2, -M_SQRT1_2)})
      if (hasFloor(at, way) && hasFloor(at, -way))
        return true;
    return false;
  };
  std::vector<CellValue> heights; // of what stands there
  for (const auto& [key, off] : off_[room]) {
    const Eigen::Vector2d at = tiles_.centre(cellOf(key));
    const double height = off.ceiling - lookup.floorAt(at);
    const auto [seen, all] = seenBetween(key, off);
    if (seen == 0 || seen < all - 1 || (off.once & top).any() || !isThin(at))
      continue;
    std::size_t first = 0;
    while (!off.once[first])
      ++first;
    heights.emplace_back(key, height - wall_tile * static_cast<double>(first));
  }
  const CellSet cells = cellsOf(heights);
  const CellRegions regions = labelRegions(cells);
  struct Place {
    Eigen::Vector2d at;
    double height;
  };
  std::vector<std::vector<Place>> places(regions.sizes.size());
  for (std::size_t k = 0; k < cells.size(); ++k)
    places[regions.label[k]].push_back({tiles_.centre(cells[k]), heights[k].second});
  const auto farthestFrom = [](const Eigen::Vector2d& from,
                               const std::vector<Place>& all) {
    return std::max_element(all.begin(), all.end(),
                            [&](const Place& a, const Place& b) {
                              return (a.at - from).norm() < (b.at - from).norm();
                            })
        ->at;
  };
  PlanWarning told{WarningKind::Standing, {0, 0}, rooms_[room].room().id};
  double longest = 0;
  for (const std::vector<Place>& wall : places) {
    const Eigen::Vector2d start = farthestFrom(wall.front().at, wall);
    const Eigen::Vector2d end = farthestFrom(start, wall);
    const double length = (end - start).norm();
    if (length < shortest)
      continue;
    double height = 0;
    for (const Place& place : wall)
      height += place.height / static_cast<double>(wall.size());
    told.values[0] += 2 * length * height; // both faces
    told.values[1] = std::max(told.values[1], height);
    if (length > longest)
      told.at = (start + end) / 2;
    longest = std::max(longest, length);
  }
  if (longest > 0)
    warnings.push_back(told);
}

} // namespace pcl::sedr
