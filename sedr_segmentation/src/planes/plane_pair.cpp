// SPDX-License-Identifier: BSD-3-Clause
#include "plane_pair.h"

#include "sedr_filters/src/base/exactness.h"
#include "sedr_filters/src/base/parallel_for.h"
#include <pcl/sedr_filters/cell_grid.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <utility>

namespace pcl::sedr {

namespace {

constexpr double cell_size = 0.1; ///< also the height of a slab, metres

/** @brief The points within a height of `cell_size` along an axis. */
struct Slab {
  std::int32_t level = 0; ///< in multiples of `cell_size`
  std::vector<int> points;
  std::size_t cells = 0; ///< distinct cells, after counting
};

constexpr std::int32_t no_level = std::numeric_limits<std::int32_t>::min();

/** @brief Returns the level of each point, `no_level` if it is not finite or farther
 * away than any building. */
std::vector<std::int32_t>
levelsOf(const PointView& points,
         const std::vector<int>& indices,
         const Eigen::Vector3d& across,
         unsigned threads)
{
  const auto levelOf = [&](int i) {
    const Eigen::Vector3d p = points[static_cast<std::size_t>(i)].cast<double>();
    const bool is_near = std::abs(p.x()) < farthest_place &&
                         std::abs(p.y()) < farthest_place &&
                         std::abs(p.z()) < farthest_place; // false for NaN
    const double height = is_near ? across.dot(p) / cell_size : 0;
    const auto whole = static_cast<std::int32_t>(height); // faster than std::floor()
    return is_near ? whole - (height < whole ? 1 : 0) : no_level;
  };
  std::vector<std::int32_t> levels(indices.size());
  parallelFor(indices.size(), points_a_block, threads,
              [&](std::size_t k) { levels[k] = levelOf(indices[k]); });
  return levels;
}

/** @brief Returns the slabs with at least `least` points. */
std::vector<Slab>
slabsOf(const PointView& points,
        const std::vector<int>& indices,
        const Eigen::Vector3d& across,
        std::size_t least,
        unsigned threads)
{
  const std::vector<std::int32_t> levels = levelsOf(points, indices, across, threads);
  std::int32_t lowest = std::numeric_limits<std::int32_t>::max();
  std::int32_t highest = no_level;
  for (const std::int32_t level : levels) {
    highest = std::max(highest, level);
    lowest = level == no_level ? lowest : std::min(lowest, level);
  }
  if (highest == no_level)
    return {};
  std::vector<std::size_t> counts(static_cast<std::size_t>(highest - lowest) + 1, 0);
  for (const std::int32_t level : levels)
    if (level != no_level)
      ++counts[static_cast<std::size_t>(level - lowest)];
  std::vector<Slab> slabs;
  std::vector<std::size_t> slab_of(counts.size(), CellSet::npos);
  for (std::size_t k = 0; k < counts.size(); ++k)
    if (counts[k] > 0 && counts[k] >= least) {
      slab_of[k] = slabs.size();
      slabs.push_back({lowest + static_cast<std::int32_t>(k), {}});
      slabs.back().points.reserve(counts[k]);
    }
  for (std::size_t k = 0; k < levels.size(); ++k)
    if (levels[k] != no_level)
      if (const auto own = slab_of[static_cast<std::size_t>(levels[k] - lowest)];
          own != CellSet::npos)
        slabs[own].points.push_back(indices[k]);
  return slabs;
}

std::size_t
countCells(const PointView& points,
           const std::vector<int>& own,
           const Eigen::Matrix3d& axes,
           unsigned threads)
{
  const CellGrid grid(cell_size);
  std::vector<CellKey> keys(own.size());
  const auto keyOfPoint = [&](int i) {
    const Eigen::Vector3d p = axes * points[static_cast<std::size_t>(i)].cast<double>();
    return keyOf(grid.at(p[0], p[1]));
  };
  parallelFor(own.size(), points_a_block, threads,
              [&](std::size_t k) { keys[k] = keyOfPoint(own[k]); });
  return CellSet(std::move(keys)).size();
}

} // namespace

PlanePair
bestPair(const PointView& points,
         const std::vector<int>& indices,
         const Eigen::Matrix3d& axes,
         double nearest,
         double farthest,
         std::size_t min_cells,
         unsigned threads)
{
  std::vector<Slab> slabs = slabsOf(points, indices, axes.row(2), min_cells, threads);
  std::sort(slabs.begin(), slabs.end(), [](const Slab& a, const Slab& b) {
    return a.points.size() != b.points.size() ? a.points.size() > b.points.size()
                                              : a.level < b.level;
  });
  PlanePair best;
  std::pair<std::int32_t, std::int32_t> levels_of_best;
  for (auto slab = slabs.begin(); slab != slabs.end(); ++slab) {
    if (slab->points.size() < best.cells)
      break; // no pair with this or a smaller one is better
    slab->cells = countCells(points, slab->points, axes, threads);
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

namespace {

/** @brief Returns the bounding box of all finite points. */
Eigen::AlignedBox3f
boxAround(const PointView& points, const std::vector<int>& indices, unsigned threads)
{
  std::vector<Eigen::AlignedBox3f> parts(indices.size() / points_a_block + 1);
  parallelBlocks(
      indices.size(), points_a_block, threads, [&](std::size_t begin, std::size_t end) {
        Eigen::AlignedBox3f part;
        for (std::size_t k = begin; k < end; ++k)
          if (const auto i = static_cast<std::size_t>(indices[k]); points.isFinite(i))
            part.extend(points[i]);
        parts[begin / points_a_block] = part;
      });
  Eigen::AlignedBox3f box;
  for (const Eigen::AlignedBox3f& part : parts)
    box.extend(part);
  return box;
}

} // namespace

SidePair
bestSidePair(const PointView& points,
             const std::vector<int>& indices,
             const Eigen::Vector3d& up,
             double least,
             unsigned threads,
             const Priors& priors)
{
  const double min_area = 2 * priors.min_slab_area;
  const Eigen::AlignedBox3f box = boxAround(points, indices, threads);
  const Eigen::Vector3d reach =
      box.isEmpty() ? Eigen::Vector3d(Eigen::Vector3d::Zero())
                    : Eigen::Vector3d(box.sizes().cast<double>().array() + 0.2);
  std::vector<int> asked;
  for (const int axis : {0, 1})
    if (std::abs(up[axis]) <= priors.same_axis && reach[2] * reach[1 - axis] > least)
      asked.push_back(axis);
  std::vector<PlanePair> pairs(asked.size());
  parallelBlocks(asked.size(), 1, threads, [&](std::size_t a, std::size_t) {
    Eigen::Matrix3d axes;
    for (int k = 0; k < 3; ++k)
      axes.row(k) = Eigen::Vector3d::Unit((asked[a] + 1 + k) % 3);
    pairs[a] = bestPair(
        points, indices, axes, priors.min_headroom, priors.usual_room_height,
        static_cast<std::size_t>(std::max(least, min_area) / (cell_size * cell_size)),
        threads);
  });
  SidePair best;
  for (std::size_t a = 0; a < asked.size(); ++a) {
    const PlanePair& found = pairs[a];
    if (found.area() < min_area || found.area() <= least || found.cells < best.cells)
      continue;
    static_cast<PlanePair&>(best) = found;
    best.axis = asked[a] == 0 ? 'x' : 'y';
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
