// SPDX-License-Identifier: BSD-3-Clause
#include "plane_pair.h"

#include "sedr_filters/src/base/exactness.h"
#include <pcl/sedr_filters/cell_grid.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <utility>

namespace pcl::sedr {

namespace {

constexpr double cell_size = 0.1; ///< also the height of a slab, metres

/** @brief The cells of the points within a height of `cell_size` along an axis. */
struct Slab {
  std::int32_t level = 0;      ///< in multiples of `cell_size`
  std::vector<CellKey> points; ///< the cell of each
  std::size_t cells = 0;       ///< distinct ones, after counting
};

/** @brief Returns the slabs with at least `least` points, of those near enough for any
 * building, the largest first. */
std::vector<Slab>
slabsOf(const PointView& points,
        const std::vector<int>& indices,
        const Eigen::Matrix3d& axes,
        std::size_t least)
{
  const CellGrid grid(cell_size);
  std::map<std::int32_t, Slab> by_level;
  Slab* last = nullptr;
  for (const int i : indices) {
    const Eigen::Vector3d at = points[static_cast<std::size_t>(i)].cast<double>();
    if (!(at.cwiseAbs().maxCoeff() < farthest_place) || !at.allFinite())
      continue;
    const Eigen::Vector3d p = axes * at;
    const auto level = static_cast<std::int32_t>(std::floor(p.z() / cell_size));
    if (!last || last->level != level)
      last = &by_level[level];
    last->level = level;
    last->points.push_back(keyOf(grid.at(p.x(), p.y())));
  }
  std::vector<Slab> slabs;
  for (auto& [level, slab] : by_level)
    if (slab.points.size() >= least)
      slabs.push_back(std::move(slab));
  std::stable_sort(slabs.begin(), slabs.end(), [](const Slab& a, const Slab& b) {
    return a.points.size() > b.points.size();
  });
  return slabs;
}

} // namespace

PlanePair
bestPair(const PointView& points,
         const std::vector<int>& indices,
         const Eigen::Matrix3d& axes,
         double nearest,
         double farthest,
         std::size_t min_cells)
{
  std::vector<Slab> slabs = slabsOf(points, indices, axes, min_cells);
  PlanePair best;
  std::pair<std::int32_t, std::int32_t> levels_of_best;
  for (auto slab = slabs.begin(); slab != slabs.end(); ++slab) {
    if (slab->points.size() < best.cells)
      break; // no pair with this or a smaller one is better
    slab->cells = CellSet(std::move(slab->points)).size();
    best.largest_cells = std::max(best.largest_cells, slab->cells);
    for (auto other = slabs.begin(); other != slab; ++other) {
      const std::pair<std::int32_t, std::int32_t> levels =
          std::minmax(slab->level, other->level);
      const double distance =
          static_cast<double>(levels.second - levels.first) * cell_size;
      const std::size_t cells = std::min(slab->cells, other->cells);
      if (distance < nearest || distance > farthest || cells < best.cells ||
          (cells == best.cells && !(levels < levels_of_best)))
        continue;
      best.cells = cells;
      best.distance = distance;
      levels_of_best = levels;
    }
  }
  return best;
}

SidePair
bestSidePair(const PointView& points,
             const std::vector<int>& indices,
             const Eigen::Vector3d& up,
             double least,
             const Priors& priors)
{
  const double min_area = std::max(least, 2 * priors.min_slab_area);
  SidePair best;
  for (const int axis : {0, 1}) {
    if (std::abs(up[axis]) > priors.same_axis)
      continue;
    Eigen::Matrix3d axes;
    for (int k = 0; k < 3; ++k)
      axes.row(k) = Eigen::Vector3d::Unit((axis + 1 + k) % 3);
    const PlanePair found =
        bestPair(points, indices, axes, priors.min_headroom, priors.usual_room_height,
                 static_cast<std::size_t>(min_area / (cell_size * cell_size)));
    if (found.area() < min_area || found.area() <= least || found.cells < best.cells)
      continue;
    static_cast<PlanePair&>(best) = found;
    best.axis = axis == 0 ? 'x' : 'y';
  }
  return best;
}

std::string
sideProblem(const SidePair& side,
            const Eigen::Vector3d& up,
            const PlanePair& pair,
            const Priors& priors)
{
  std::array<char, 48> across{"z"};
  if (up.z() < std::cos(priors.same_axis))
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

} // namespace pcl::sedr
