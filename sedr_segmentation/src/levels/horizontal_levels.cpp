// SPDX-License-Identifier: BSD-3-Clause
#include "height_windows.h"
#include "level_candidates.h"
#include "level_contrast.h"
#include "level_parting.h"
#include "level_regions.h"
#include "level_relief.h"
#include "level_steps.h"

#include "horizontal_levels.h"

#include "sedr_filters/src/base/plane_fit.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl::sedr {

namespace {

/** @brief Maximum number of rounds of plane fit and region search. */
constexpr int max_rounds = 10;

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

/** @brief Returns the positions of the candidates within `band` of a level's plane. */
std::vector<std::size_t>
nearPlane(const LevelColumns& columns,
          const std::vector<Candidate>& candidates,
          const LevelDraft& draft,
          double band)
{
  std::vector<std::size_t> near;
  for (const Candidate& c : stretchNear(columns, candidates, draft.slab, band))
    if (!draft.apart[c.cell] &&
        std::abs(distanceAbove(draft.slab, c.position())) <= band)
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

/** @brief Returns the maximum distance of a plane's noise: six standard deviations,
 * between one and two tolerances. Points evenly spread within the tolerance are no
 * noise but a surface that bends away. */
double
reachOfNoise(const PlanSlab& slab, double tolerance)
{
  const bool is_noise = slab.residual < 0.45 * tolerance;
  return is_noise ? std::clamp(6 * slab.residual, tolerance, 2 * tolerance) : tolerance;
}

/** @brief Returns the points of a level and the tails of its noise in and next to its
 * own cells. The tails would look like further levels just above and below; elsewhere
 * such points may be a level. */
std::vector<std::size_t>
withTails(const LevelColumns& columns,
          const std::vector<Candidate>& candidates,
          const LevelDraft& draft,
          const PlanSlab& slab,
          double tolerance)
{
  std::vector<std::size_t> near =
      nearPlane(columns, candidates, draft, reachOfNoise(slab, tolerance));
  const auto isElsewhere = [&](std::size_t k) {
    if (draft.cells[candidates[k].cell]) // the usual case
      return false;
    const CellBlock block = blockAround(columns.cells(), candidates[k].cell);
    return std::none_of(block.begin(), block.end(),
                        [&](std::size_t b) { return draft.cells[b] != 0; });
  };
  near.erase(std::remove_if(near.begin(), near.end(), isElsewhere), near.end());
  return near;
}

/** @brief Fits a plane to candidates in marked cells within the tolerance of `near`. */
PlanSlab
slabOver(const LevelColumns& columns,
         const std::vector<Candidate>& candidates,
         const std::vector<std::uint8_t>& marked,
         const PlanSlab& near,
         double tolerance)
{
  Positions own;
  for (const Candidate& c : stretchNear(columns, candidates, near, tolerance))
    if (marked[c.cell] && std::abs(distanceAbove(near, c.position())) <= tolerance)
      own.push_back(c.position());
  return fitSlabRobustly(own, near, tolerance);
}

/** @brief Keeps a level that stands out, or else only its regions that do. At the
 * height of a small ceiling there may be clutter throughout the building.
 * @return whether anything is left */
bool
keepWhatStandsOut(const LevelColumns& columns,
                  const std::vector<Candidate>& candidates,
                  double tolerance,
                  std::size_t minimum_cells,
                  LevelDraft& draft)
{
  const auto count = std::count(draft.cells.begin(), draft.cells.end(), 1);
  if (static_cast<std::size_t>(count) < minimum_cells)
    return false;
  if (standsOut(columns, draft.cells, draft.slab, tolerance))
    return true;
  std::vector<std::uint8_t> standing;
  for (const auto& region :
       levelRegions(columns, draft.cells, draft.slab, tolerance, minimum_cells)) {
    std::vector<std::uint8_t> alone(draft.cells.size(), 0);
    for (const std::size_t i : region)
      alone[i] = 1;
    if (!standsOut(columns, alone, draft.slab, tolerance))
      continue;
    standing.resize(draft.cells.size(), 0);
    for (const std::size_t i : region)
      standing[i] = 1;
  }
  if (standing.empty())
    return false;
  draft.slab = slabOver(columns, candidates, standing, draft.slab, tolerance);
  draft.cells = std::move(standing);
  return true;
}

/** @brief Fits a plane to the candidates in and just outside a window, as it may tilt.
 */
PlanSlab
slabOfWindow(const std::vector<Candidate>& candidates,
             const HeightWindow& window,
             const LevelParameters& parameters,
             std::uint64_t seed)
{
  const double low = candidates[window.first].z - 2 * parameters.tolerance;
  const double high = candidates[window.last - 1].z + 2 * parameters.tolerance;
  const auto first =
      std::lower_bound(candidates.begin(), candidates.end(), low,
                       [](const Candidate& c, double z) { return c.z < z; });
  const auto last =
      std::upper_bound(first, candidates.end(), high,
                       [](double z, const Candidate& c) { return z < c.z; });
  Positions around;
  around.reserve(static_cast<std::size_t>(last - first));
  for (auto c = first; c != last; ++c)
    around.push_back(c->position());
  return findLargerSlab(around, parameters.tolerance, parameters.maximum_tilt, seed,
                        parameters.threads);
}

/** @brief Returns the cells of a level and those up to two cells away: its walls. */
CellSet
withRim(const CellSet& all, const CellSet& cells)
{
  std::vector<std::uint8_t> marked(all.size(), 0);
  for (std::size_t i = 0; i < cells.size(); ++i)
    for (const std::size_t near : blockAround(all, all.find(cells[i])))
      for (const std::size_t k : blockAround(all, near))
        marked[k] = 1;
  return markedCells(all, marked);
}

/** @brief Excludes from a level the cells and wall cells of earlier levels from which
 * it was separated. */
void
keepApart(const CellSet& all,
          const std::vector<Level>& earlier,
          std::vector<CellSet>& with_rims,
          Level& level)
{
  with_rims.resize(earlier.size());
  for (std::size_t l = 0; l < earlier.size(); ++l) {
    if (2 * intersect(level.cells, earlier[l].without).size() <= level.cells.size())
      continue;
    if (with_rims[l].empty())
      with_rims[l] = withRim(all, earlier[l].cells);
    level.without = unite(level.without, subtract(with_rims[l], level.cells));
  }
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
  std::vector<CellSet> with_rims; // computed on demand per level
  while (true) {
    const HeightWindow window = densestWindow(candidates, 2 * parameters.tolerance,
                                              cells.size(), minimum_cells - 1);
    if (window.cells == 0)
      break;
    LevelDraft draft;
    draft.slab =
        slabOfWindow(candidates, window, parameters, parameters.seed + levels.size());
    draft.apart.assign(cells.size(), 0);
    for (int round = 0;; ++round) {
      draft.relief =
          reliefOf(columns, candidates, draft.slab, 2 * parameters.tolerance);
      if (round == max_rounds ||
          !partLevel(columns, candidates, parameters, minimum_cells, draft))
        break;
    }
    setStepsApart(columns, parameters.tolerance, parameters.priors, draft);
    std::vector<std::size_t> own =
        nearPlane(columns, candidates, draft, parameters.tolerance);
    draft.cells = cellsOf(candidates, own, cells.size());
    if (keepWhatStandsOut(columns, candidates, parameters.tolerance, minimum_cells,
                          draft)) {
      Level level;
      level.slab = draft.slab;
      level.cells = markedCells(cells, draft.cells);
      own = withTails(columns, candidates, draft, level.slab, parameters.tolerance);
      level.without = markedCells(cells, draft.apart);
      keepApart(cells, levels, with_rims, level);
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
