// SPDX-License-Identifier: BSD-3-Clause
#include "level_candidates.h"

#include "horizontal_levels.h"

#include "sedr_filters/src/base/exactness.h"
#include "sedr_filters/src/base/parallel.h"
#include "sedr_filters/src/base/parallel_for.h"
#include "sedr_filters/src/base/plane_fit.h"
#include "sedr_filters/src/grids/digit_sort.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

namespace {

/** @brief Returns the level of each point: the nearest within the tolerance among those
 * found in its cell, or else among all. The plane of one room's ceiling may pass close
 * to another's. Other points get the number of levels. */
std::vector<std::size_t>
ownLevels(const std::vector<Level>& levels,
          const LevelColumns& columns,
          const LevelParameters& parameters)
{
  const double tolerance = parameters.tolerance;
  const std::vector<Candidate>& all = columns.all();
  std::vector<std::size_t> own(all.size(), levels.size());
  std::vector<HeightRange> reach;
  for (const Level& level : levels)
    reach.push_back(heightsNear(columns, level.slab, tolerance));
  const auto look = [&](std::size_t k) {
    const Cell cell = columns.cells()[all[k].cell];
    double least = tolerance;
    bool is_found_there = false;
    for (std::size_t l = 0; l < levels.size(); ++l) {
      if (all[k].z < reach[l].low || all[k].z > reach[l].high) // the usual case
        continue;
      const double d = std::abs(distanceAbove(levels[l].slab, all[k].position()));
      if (d > tolerance)
        continue;
      const bool is_here = levels[l].cells.contains(cell);
      const bool is_nearer = d < least || (d == least && own[k] == levels.size());
      if (is_here == is_found_there ? !is_nearer : is_found_there)
        continue;
      least = d;
      own[k] = l;
      is_found_there = is_here;
    }
  };
  parallelFor(all.size(), points_a_block, parameters.threads,
              [&](std::size_t k) { look(k); });
  return own;
}

/** @brief Marks the cells where a level has no inliers: cells of walls and cells
 * outside `within`. Just below a ceiling or above a floor, only walls have points.
 * @param asked marks the cells to test */
std::vector<std::uint8_t>
cellsLeftOut(const LevelColumns& columns,
             const std::vector<std::uint8_t>& asked,
             double tolerance,
             const Level& level)
{
  const CellSet& cells = columns.cells();
  std::vector<std::uint8_t> left_out(cells.size(), 0);
  if (level.kind != LevelKind::Other)
    left_out = columnsThatGoOn(columns, asked, level.slab,
                               level.kind == LevelKind::Ceiling ? -1 : 1, tolerance);
  if (!level.within.empty())
    for (std::size_t i = 0; i < cells.size(); ++i)
      if (asked[i] && !level.within.contains(cells[i]))
        left_out[i] = 1;
  return left_out;
}

/** @brief Returns the maximum distance of a plane's own points: four standard
 * deviations, at least 1.5 cm, at most the tolerance; metres. */
double
noiseOf(const PlanSlab& slab, double tolerance, const Priors& priors)
{
  return std::min(tolerance, std::max(4 * slab.residual, priors.slab_noise));
}

/** @brief Returns the cells that lie in a block of 5 x 5 with more than 10 cells of the
 * set, i.e. more than a strip two cells wide. This keeps uneven parts of a ceiling and
 * removes the last centimetres of a wall below it. */
CellSet
withoutFringes(const CellSet& cells)
{
  std::vector<std::uint8_t> is_kept(cells.size(), 0);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    std::size_t count = 0;
    forEachAround(cells, cells[i], 2, [&](std::size_t) { ++count; });
    if (count > 10)
      forEachAround(cells, cells[i], 2, [&](std::size_t k) { is_kept[k] = 1; });
  }
  return markedCells(cells, is_kept);
}

/** @brief Sets the inliers and cells of a level: its own points without those of walls.
 */
void
takeInliers(const LevelColumns& columns,
            const std::vector<std::size_t>& own,
            const LevelParameters& parameters,
            Level& level)
{
  const double tolerance = parameters.tolerance;
  const std::vector<Candidate>& all = columns.all();
  const CellSet& cells = columns.cells();
  std::vector<std::uint8_t> asked(cells.size(), 0);
  for (const std::size_t k : own)
    asked[all[k].cell] = 1;
  const std::vector<std::uint8_t> left_out =
      cellsLeftOut(columns, asked, tolerance, level);
  // Cells with points on the plane (`on`) or only near it (`near`).
  const double on_plane = noiseOf(level.slab, tolerance, parameters.priors);
  std::vector<std::uint8_t> on(cells.size(), 0);
  for (const std::size_t k : own)
    if (!left_out[all[k].cell] &&
        std::abs(distanceAbove(level.slab, all[k].position())) <= on_plane)
      on[all[k].cell] = 1;
  std::vector<std::uint8_t> near(cells.size(), 0);
  for (std::size_t i = 0; i < cells.size(); ++i)
    near[i] = asked[i] && !left_out[i] && !on[i] ? 1 : 0;
  const CellSet beside = withoutFringes(markedCells(cells, near));
  for (std::size_t i = 0; i < beside.size(); ++i)
    on[cells.find(beside[i])] = 1;
  level.cells = markedCells(cells, on);
  level.inliers.clear();
  for (const std::size_t k : own)
    if (on[all[k].cell])
      level.inliers.push_back(all[k].index);
  sortByDigits(level.inliers, [](int i) { return static_cast<std::uint32_t>(i); });
}

} // namespace

void
collectInliers(std::vector<Level>& levels,
               const PointView& points,
               const std::vector<int>& indices,
               const LevelParameters& parameters)
{
  collectInliers(levels, columnsOf(points, indices, parameters), parameters);
}

void
collectInliers(std::vector<Level>& levels,
               const LevelColumns& columns,
               const LevelParameters& parameters)
{
  const std::vector<std::size_t> level_of = ownLevels(levels, columns, parameters);
  std::vector<std::vector<std::size_t>> own(levels.size() + 1);
  for (std::size_t k = 0; k < level_of.size(); ++k)
    own[level_of[k]].push_back(k);
  parallelBlocks(levels.size(), 1, parameters.threads, [&](std::size_t l, std::size_t) {
    takeInliers(columns, own[l], parameters, levels[l]);
  });
}

} // namespace pcl::sedr
