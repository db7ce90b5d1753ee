// SPDX-License-Identifier: BSD-3-Clause
#include "height_windows.h"
#include "level_candidates.h"

#include "horizontal_levels.h"

#include "sedr_filters/src/base/plane_fit.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace pcl::sedr {

namespace {

/** @brief Marks the cells that hold a chosen candidate. */
std::vector<std::uint8_t>
cellsOf(const std::vector<Candidate>& candidates,
        const std::vector<std::size_t>& chosen,
        std::size_t cell_count)
{
  std::vector<std::uint8_t> marked(cell_count, 0);
  for (const std::size_t k : chosen)
    marked[candidates[k].cell] = 1;
  return marked;
}

/** @brief Returns the positions of the candidates within `band` of a plane. */
std::vector<std::size_t>
nearPlane(const LevelColumns& columns,
          const std::vector<Candidate>& candidates,
          const PlanSlab& slab,
          double band)
{
  std::vector<std::size_t> near;
  for (const Candidate& c : stretchNear(columns, candidates, slab, band))
    if (std::abs(distanceAbove(slab, c.position())) <= band)
      near.push_back(static_cast<std::size_t>(&c - candidates.data()));
  return near;
}

/** @brief Returns the height of a level at the centre of its cells. Far from there the
 * plane of a small level is unreliable. */
double
heightOverOwnCells(const Level& level, const CellGrid& grid)
{
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < level.cells.size(); ++i)
    middle += grid.centre(level.cells[i]) / static_cast<double>(level.cells.size());
  return level.slab.heightAt(middle);
}

/** @brief Returns whether the points of a plane are noise. Points evenly spread within
 * the tolerance are a surface that bends away, or several. */
bool
isNoise(const PlanSlab& slab, double tolerance)
{
  return slab.residual < 0.45 * tolerance;
}

/** @brief Returns the maximum distance of a plane's noise: six standard deviations,
 * between one and two tolerances. */
double
reachOfNoise(const PlanSlab& slab, double tolerance)
{
  return isNoise(slab, tolerance)
             ? std::clamp(6 * slab.residual, tolerance, 2 * tolerance)
             : tolerance;
}

/** @brief Returns the points of a level and the tails of its noise in and next to its
 * own cells. The tails would look like further levels just above and below; elsewhere
 * such points may be a level. */
std::vector<std::size_t>
withTails(const LevelColumns& columns,
          const std::vector<Candidate>& candidates,
          const std::vector<std::uint8_t>& cells,
          const PlanSlab& slab,
          double tolerance)
{
  std::vector<std::size_t> near =
      nearPlane(columns, candidates, slab, reachOfNoise(slab, tolerance));
  const auto isElsewhere = [&](std::size_t k) {
    if (cells[candidates[k].cell]) // the usual case
      return false;
    const CellBlock block = blockAround(columns.cells(), candidates[k].cell);
    return std::none_of(block.begin(), block.end(),
                        [&](std::size_t b) { return cells[b] != 0; });
  };
  near.erase(std::remove_if(near.begin(), near.end(), isElsewhere), near.end());
  return near;
}

/** @brief Draws one point of each cell from a range of candidates: cells count, not
 * points, or the clutter on a sparse floor would outnumber it. */
Positions
onePointACell(const Candidate* first,
              const Candidate* last,
              std::size_t cell_count,
              std::uint64_t seed)
{
  std::mt19937_64 random(seed);
  std::vector<std::uint32_t> points_in(cell_count, 0);
  std::vector<const Candidate*> drawn(cell_count, nullptr);
  for (const Candidate* c = first; c != last; ++c)
    if (random() % ++points_in[c->cell] == 0)
      drawn[c->cell] = c;
  Positions positions;
  for (const Candidate* c : drawn)
    if (c)
      positions.push_back(c->position());
  return positions;
}

/** @brief Finds the plane on which the points are densest, within the noise of a slab:
 * clutter beside it and rugs on it stay outside. It is refitted within the tolerance if
 * its points there are noise, and not several surfaces. */
PlanSlab
densestSlab(const Positions& points,
            const LevelParameters& parameters,
            std::uint64_t seed)
{
  const double tolerance = parameters.tolerance;
  const PlanSlab core =
      findSlab(points, std::min(parameters.priors.slab_noise, tolerance),
               parameters.maximum_tilt, seed, parameters.threads);
  const PlanSlab whole = fitSlabRobustly(points, core, tolerance);
  const bool is_level = whole.plane[2] >= std::cos(parameters.maximum_tilt);
  return is_level && isNoise(whole, tolerance) ? whole : core;
}

/** @brief Fits a plane to the candidates in and just outside a window, as it may tilt.
 */
PlanSlab
slabOfWindow(const LevelColumns& columns,
             const std::vector<Candidate>& candidates,
             const HeightWindow& window,
             const LevelParameters& parameters,
             std::uint64_t seed)
{
  const double low = candidates[window.first].z - 2 * parameters.tolerance;
  const double high = candidates[window.last - 1].z + 2 * parameters.tolerance;
  const Candidate* const end = candidates.data() + candidates.size();
  const Candidate* const first =
      std::lower_bound(candidates.data(), end, low,
                       [](const Candidate& c, double z) { return c.z < z; });
  const Candidate* const last = std::upper_bound(
      first, end, high, [](double z, const Candidate& c) { return z < c.z; });
  return densestSlab(onePointACell(first, last, columns.cells().size(), seed),
                     parameters, seed);
}

} // namespace

LevelColumns
columnsOf(const PointView& points,
          const std::vector<int>& indices,
          const LevelParameters& parameters)
{
  return LevelColumns(points, indices, parameters.cell_size, parameters.tolerance,
                      parameters.threads);
}

std::vector<Level>
findLevels(const PointView& points,
           const std::vector<int>& indices,
           const LevelParameters& parameters,
           HeightHistogram* histogram)
{
  return findLevels(columnsOf(points, indices, parameters), parameters, histogram);
}

std::vector<Level>
findLevels(const LevelColumns& columns,
           const LevelParameters& parameters,
           HeightHistogram* histogram)
{
  const CellGrid& grid = columns.grid();
  const CellSet& cells = columns.cells();
  std::vector<Candidate> candidates = columns.withoutWalls();
  if (histogram)
    *histogram = histogramOf(candidates, parameters.tolerance / 2, cells.size());
  const auto minimum_cells = std::max<std::size_t>(
      1, static_cast<std::size_t>(
             std::ceil(parameters.minimum_area / (grid.size() * grid.size()) - 1e-9)));

  std::vector<Level> levels;
  while (true) {
    const HeightWindow window = densestWindow(candidates, 2 * parameters.tolerance,
                                              cells.size(), minimum_cells - 1);
    if (window.cells == 0)
      break;
    Level level;
    level.slab = slabOfWindow(columns, candidates, window, parameters,
                              parameters.seed + levels.size());
    std::vector<std::size_t> own =
        nearPlane(columns, candidates, level.slab, parameters.tolerance);
    const std::vector<std::uint8_t> marked = cellsOf(candidates, own, cells.size());
    level.cells = markedCells(cells, marked);
    if (level.cells.size() >= minimum_cells) {
      own = withTails(columns, candidates, marked, level.slab, parameters.tolerance);
      levels.push_back(std::move(level));
    }
    else { // no plane: the window's points are clutter
      own.resize(window.last - window.first);
      std::iota(own.begin(), own.end(), window.first);
    }
    erase(candidates, own);
  }

  for (auto& level : levels)
    level.height = heightOverOwnCells(level, grid);
  std::sort(levels.begin(), levels.end(),
            [](const Level& a, const Level& b) { return a.height < b.height; });
  return levels;
}

} // namespace pcl::sedr
