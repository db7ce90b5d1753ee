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

namespace {

constexpr double most_off = 0.026; ///< of an axis from square to another one, radians

} // namespace

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
  auto last = slabs.end(); // where most of the next points are too
  for (const int i : indices) {
    if (!points.isFinite(static_cast<std::size_t>(i)))
      continue;
    const Eigen::Vector3d p = axes * points[static_cast<std::size_t>(i)].cast<double>();
    if (!grid.holds(p[0], p[1]) || !grid.holds(p[2], 0))
      continue;
    const auto level = static_cast<std::int64_t>(std::floor(p[2] / cell));
    if (last == slabs.end() || last->first != level)
      last = slabs.try_emplace(level).first;
    last->second.push_back(keyOf(grid.at(p[0], p[1])));
  }
  std::vector<std::pair<std::int64_t, std::size_t>> sizes;
  for (auto& [level, keys] : slabs)
    sizes.emplace_back(level, CellSet(std::move(keys)).size());
  PlanePair best;
  for (const auto& [level, cells] : sizes)
    best.largest_cells = std::max(best.largest_cells, cells);
  for (std::size_t a = 0; a < sizes.size(); ++a)
    for (std::size_t b = a + 1; b < sizes.size(); ++b) {
      const double distance =
          static_cast<double>(sizes[b].first - sizes[a].first) * cell;
      if (distance > farthest)
        break;
      const std::size_t cells = std::min(sizes[a].second, sizes[b].second);
      if (distance < nearest || cells <= best.cells)
        continue;
      best.cells = cells;
      best.distance = distance;
    }
  return best;
}

SidePair
bestSidePair(const PointView& points,
             const std::vector<int>& indices,
             const Eigen::Vector3d& up,
             double least)
{
  constexpr double least_area = 2; // square metres
  Eigen::AlignedBox3f box;
  for (const int i : indices)
    if (points.isFinite(static_cast<std::size_t>(i)))
      box.extend(points[static_cast<std::size_t>(i)]);
  const Eigen::Vector3d reach =
      box.isEmpty() ? Eigen::Vector3d(Eigen::Vector3d::Zero())
                    : Eigen::Vector3d(box.sizes().cast<double>().array() + 0.2);
  SidePair best;
  for (const int axis : {0, 1}) {
    if (std::abs(up[axis]) > most_off || reach[2] * reach[1 - axis] <= least)
      continue;
    Eigen::Matrix3d axes;
    for (int k = 0; k < 3; ++k)
      axes.row(k) = Eigen::Vector3d::Unit((axis + 1 + k) % 3);
    const PlanePair found =
        bestPair(points, indices, axes, lowest_room, highest_usual_room);
    if (found.area() < least_area || found.area() <= least || found.cells < best.cells)
      continue;
    static_cast<PlanePair&>(best) = found;
    best.axis = axis == 0 ? 'x' : 'y';
  }
  return best;
}

std::string
sideProblem(const SidePair& side, const Eigen::Vector3d& up, const PlanePair& pair)
{
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
                side.axis, side.area(), side.distance, across.data(), pair.area(),
                pair.distance, side.turn());
  return text.data();
}

} // namespace sedr
} // namespace pcl
