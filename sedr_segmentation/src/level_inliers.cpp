// SPDX-License-Identifier: BSD-3-Clause
#include "level_candidates.h"
#include "level_steps.h"

#include <pcl/sedr_segmentation/horizontal_levels.h>

#include <pcl/sedr_filters/plane_fit.h>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace sedr {

namespace {

/** @brief The level of each point within the tolerance of some: the nearest of those
 * that were found in its cell; where none was, of those that may have points there. The
 * plane of one room's ceiling may pass close to that of another, but does not reach it.
 * The number of levels for the other points. */
std::vector<std::size_t>
ownLevels(const std::vector<Level>& levels,
          const std::vector<Candidate>& columns,
          const CellSet& cells,
          double tolerance)
{
  std::vector<std::size_t> own(columns.size(), levels.size());
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const Cell cell = cells[columns[k].cell];
    double least = tolerance;
    bool is_found_there = false;
    for (std::size_t l = 0; l < levels.size(); ++l) {
      const double d = std::abs(distanceAbove(levels[l].slab, columns[k].position()));
      if (d > tolerance)
        continue;
      const bool is_here = levels[l].cells.contains(cell);
      const bool is_nearer = d < least || (d == least && own[k] == levels.size());
      if (is_here == is_found_there ? !is_nearer : is_found_there)
        continue;
      if (!is_here && levels[l].without.contains(cell))
        continue;
      least = d;
      own[k] = l;
      is_found_there = is_here;
    }
  }
  return own;
}

} // namespace

void
collectInliers(std::vector<Level>& levels,
               const PointView& points,
               const std::vector<int>& indices,
               const LevelParameters& parameters)
{
  const CellGrid grid(parameters.cell_size);
  const CellSet cells(grid, points, indices);
  const std::vector<Candidate> columns = sortIntoColumns(points, indices, grid, cells);
  const std::vector<std::size_t> own =
      ownLevels(levels, columns, cells, parameters.tolerance);
  for (std::size_t l = 0; l < levels.size(); ++l) {
    Level& level = levels[l];
    level.inliers.clear();
    // Just below a ceiling, or just above a floor, a room has nothing: a wall has.
    const std::vector<std::uint8_t> goes_on =
        level.kind == LevelKind::Other
            ? std::vector<std::uint8_t>(cells.size(), 0)
            : columnsThatGoOn(columns, cells, level.slab,
                              level.kind == LevelKind::Ceiling ? -1 : 1,
                              parameters.tolerance);
    // Cells with points on the plane itself, and cells with points near it only.
    const double on_plane =
        std::clamp(4 * level.slab.residual, 0.015, parameters.tolerance);
    std::vector<CellKey> on;
    std::vector<CellKey> near;
    for (std::size_t k = 0; k < columns.size(); ++k) {
      if (own[k] != l || goes_on[columns[k].cell] ||
          !(level.within.empty() || level.within.contains(cells[columns[k].cell])))
        continue;
      const auto p = columns[k].position();
      (std::abs(distanceAbove(level.slab, p)) <= on_plane ? on : near)
          .push_back(cells.keys()[columns[k].cell]);
    }
    const CellSet core(std::move(on));
    level.cells = unite(core, withoutFringes(subtract(CellSet(std::move(near)), core)));
    for (std::size_t k = 0; k < columns.size(); ++k)
      if (own[k] == l && level.cells.contains(cells[columns[k].cell]))
        level.inliers.push_back(columns[k].index);
    std::sort(level.inliers.begin(), level.inliers.end());
  }
}

} // namespace sedr
} // namespace pcl
