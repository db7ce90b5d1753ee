// SPDX-License-Identifier: BSD-3-Clause
#include "plane_pair.h"

#include <pcl/sedr_filters/cell_grid.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <utility>

namespace pcl {
namespace sedr {

PlanePair
bestPair(const PointView& points,
         const std::vector<int>& indices,
         const Eigen::Matrix3d& axes,
         double nearest,
         double farthest)
{
  constexpr double cell = 0.1;
  const CellGrid grid(cell);
  std::map<std::int64_t, std::vector<CellKey>> slabs;
  for (const int i : indices) {
    if (!points.isFinite(static_cast<std::size_t>(i)))
      continue;
    const Eigen::Vector3d p = axes * points[static_cast<std::size_t>(i)].cast<double>();
    if (grid.holds(p[0], p[1]) && grid.holds(p[2], 0))
      slabs[static_cast<std::int64_t>(std::floor(p[2] / cell))].push_back(
          keyOf(grid.at(p[0], p[1])));
  }
  std::vector<std::pair<std::int64_t, std::size_t>> sizes;
  for (auto& [level, keys] : slabs)
    sizes.emplace_back(level, CellSet(std::move(keys)).size());
  PlanePair best;
  for (std::size_t a = 0; a < sizes.size(); ++a)
    for (std::size_t b = a + 1; b < sizes.size(); ++b) {
      const double distance =
          static_cast<double>(sizes[b].first - sizes[a].first) * cell;
      if (distance > farthest)
        break;
      const std::size_t cells = std::min(sizes[a].second, sizes[b].second);
      if (distance >= nearest && cells > best.cells)
        best = {cells, distance};
    }
  return best;
}

std::string
sideProblem(const PointView& points,
            const std::vector<int>& indices,
            const Eigen::Vector3d& up,
            const PlanePair& pair,
            double times)
{
  constexpr std::size_t least_wall = 200; // cells, 2 square metres
  constexpr double most_off = 0.026;      // from square, radians
  PlanePair side;
  int side_axis = 0;
  for (const int axis : {0, 1}) {
    if (std::abs(up[axis]) > most_off)
      continue;
    Eigen::Matrix3d axes;
    for (int k = 0; k < 3; ++k)
      axes.row(k) = Eigen::Vector3d::Unit((axis + 1 + k) % 3);
    const PlanePair found =
        bestPair(points, indices, axes, lowest_room, highest_usual_room);
    if (found.cells >= side.cells) {
      side = found;
      side_axis = axis;
    }
  }
  if (side.cells < least_wall ||
      static_cast<double>(side.cells) <= times * static_cast<double>(pair.cells))
    return {};
  std::array<char, 48> across{"z"};
  if (up.z() < std::cos(most_off))
    std::snprintf(across.data(), across.size(), "a direction at %.1f degrees to z",
                  std::acos(std::min(1.0, up.z())) * 180 / M_PI);
  std::array<char, 400> text{};
  std::snprintf(text.data(), text.size(),
                "%c seems to be up, not z: across it two planes of %.0f square metres "
                "are %.1f m apart, across %s of %.0f square metres %.1f m; turn the "
                "scan, for instance by pcl_transform_point_cloud IN OUT -axisangle "
                "%s (-1.5708 if it is upside down then)",
                side_axis == 1 ? 'y' : 'x', side.area(), side.distance, across.data(),
                pair.area(), pair.distance,
                side_axis == 1 ? "1,0,0,1.5708" : "0,-1,0,1.5708");
  return text.data();
}

} // namespace sedr
} // namespace pcl
