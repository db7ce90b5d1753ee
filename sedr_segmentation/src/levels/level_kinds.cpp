// SPDX-License-Identifier: BSD-3-Clause
#include "horizontal_levels.h"

#include "sedr_filters/src/base/parallel.h"

#include <algorithm>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief Returns the grid of the classification, coarse enough to bridge furniture. */
CellGrid
coarseGrid(const LevelParameters& parameters)
{
  return CellGrid(std::max(parameters.priors.coarse_cell, parameters.cell_size));
}

CellSet
coarsened(const CellSet& cells, const LevelParameters& parameters)
{
  const CellGrid fine(parameters.cell_size);
  const CellGrid coarse = coarseGrid(parameters);
  std::vector<CellKey> keys;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Eigen::Vector2d c = fine.centre(cells[i]);
    keys.push_back(keyOf(coarse.at(c.x(), c.y())));
  }
  return CellSet(std::move(keys));
}

/** @brief Returns the height of a level at the centre of a coarse cell. */
double
heightAt(const Level& level, Cell cell, const LevelParameters& parameters)
{
  return level.slab.heightAt(coarseGrid(parameters).centre(cell));
}

/** @brief Returns the share of the cells of `region` that level `f` covers at least a
 * room's height below `ceiling`. */
double
shareBelow(const std::vector<Level>& levels,
           const CellSet& region,
           std::size_t ceiling,
           const CellSet& coarse_f,
           std::size_t f,
           const LevelParameters& parameters)
{
  std::size_t covered = 0;
  for (std::size_t i = 0; i < region.size(); ++i) {
    const Cell cell = region[i];
    const double gap = heightAt(levels[ceiling], cell, parameters) -
                       heightAt(levels[f], cell, parameters);
    if (gap >= parameters.minimum_room_height && coarse_f.contains(cell))
      ++covered;
  }
  return region.empty()
             ? 0
             : static_cast<double>(covered) / static_cast<double>(region.size());
}

/** @brief Returns the share of a level's cells without another level above. */
double
shareOnTop(const std::vector<Level>& levels,
           const std::vector<CellSet>& coarse,
           std::size_t of,
           const LevelParameters& parameters)
{
  std::size_t topmost = 0;
  for (std::size_t i = 0; i < coarse[of].size(); ++i) {
    const Cell cell = coarse[of][i];
    const double height = heightAt(levels[of], cell, parameters);
    bool is_top = true;
    for (std::size_t other = 0; other < levels.size() && is_top; ++other)
      is_top = other == of || !coarse[other].contains(cell) ||
               heightAt(levels[other], cell, parameters) <=
                   height + 2 * parameters.tolerance;
    topmost += is_top ? 1 : 0;
  }
  return static_cast<double>(topmost) / static_cast<double>(coarse[of].size());
}

/** @brief Returns whether a level lies a room's height below a tenth of `part`. */
bool
isHigh(const std::vector<Level>& levels,
       const std::vector<CellSet>& coarse,
       std::size_t level,
       const CellSet& part,
       const LevelParameters& parameters)
{
  for (std::size_t f = 0; f < levels.size(); ++f)
    if (shareBelow(levels, part, level, coarse[f], f, parameters) >= 0.1)
      return true;
  return false;
}

/** @brief Returns whether most cells of a region have no level above. This needs the
 * fine cells: coarse ones reach beyond the edge of a narrow soffit. */
bool
isOpenAbove(const std::vector<Level>& levels,
            std::size_t level,
            const CellSet& region,
            const LevelParameters& parameters)
{
  CellSet covered;
  for (const Level& other : levels)
    if (other.height > levels[level].height + 2 * parameters.tolerance)
      covered = unite(covered, intersect(region, other.cells));
  return 2 * covered.size() < region.size();
}

/** @brief Returns the cells of the regions that are ceilings in a level that mostly is
 * not, such as a soffit at the height of shelves, window heads or lamps elsewhere. */
CellSet
ceilingsWithin(const std::vector<Level>& levels,
               const std::vector<CellSet>& coarse,
               std::size_t level,
               const LevelParameters& parameters)
{
  const double cell_area = parameters.cell_size * parameters.cell_size;
  CellSet found;
  for (const CellSet& region : connectedRegions(levels[level].cells)) {
    if (static_cast<double>(region.size()) * cell_area >= parameters.minimum_area &&
        isOpenAbove(levels, level, region, parameters) &&
        isHigh(levels, coarse, level, coarsened(region, parameters), parameters))
      found = unite(found, region);
  }
  return found;
}

/** @brief The ceiling part of a level: none, all of it, or only the cells in `alone`.
 */
struct CeilingPart {
  bool is_any = false;
  CellSet alone;
};

CeilingPart
ceilingOf(const std::vector<Level>& levels,
          const std::vector<CellSet>& coarse,
          std::size_t level,
          const LevelParameters& parameters)
{
  if (shareOnTop(levels, coarse, level, parameters) >= 0.5)
    return {isHigh(levels, coarse, level, coarse[level], parameters), {}};
  CellSet soffits = ceilingsWithin(levels, coarse, level, parameters);
  return {!soffits.empty(), std::move(soffits)};
}

/** @brief A connected region of the union of all ceilings: roughly a room, including
 * steps and soffits. */
struct CeilingRegion {
  CellSet coarse;
  std::size_t main_level = 0; ///< the level with the maximum number of cells
};

std::vector<CeilingRegion>
ceilingRegions(const std::vector<Level>& levels, const LevelParameters& parameters)
{
  CellSet all;
  for (const auto& level : levels)
    if (level.kind == LevelKind::Ceiling)
      all = unite(all, level.cells);
  const double cell_area = parameters.cell_size * parameters.cell_size;
  std::vector<CeilingRegion> result;
  for (const CellSet& cells : connectedRegions(all)) {
    if (static_cast<double>(cells.size()) * cell_area < parameters.minimum_area)
      continue;
    CeilingRegion region;
    region.coarse = coarsened(cells, parameters);
    std::size_t most = 0;
    for (std::size_t l = 0; l < levels.size(); ++l) {
      const std::size_t shared = levels[l].kind == LevelKind::Ceiling
                                     ? intersect(levels[l].cells, cells).size()
                                     : 0;
      if (shared <= most)
        continue;
      most = shared;
      region.main_level = l;
    }
    result.push_back(std::move(region));
  }
  return result;
}

/** @brief Marks the floors below a ceiling region: the lowest level with a tenth of the
 * region, and any other with half of it. */
void
markFloorsBelow(std::vector<Level>& levels,
                const std::vector<CellSet>& coarse,
                const CeilingRegion& region,
                const LevelParameters& parameters)
{
  bool has_floor = false;
  for (std::size_t f = 0; f < levels.size(); ++f) {
    if (levels[f].kind == LevelKind::Ceiling)
      continue;
    const double share =
        shareBelow(levels, region.coarse, region.main_level, coarse[f], f, parameters);
    if (share < (has_floor ? 0.5 : 0.1))
      continue;
    levels[f].kind = LevelKind::Floor;
    has_floor = true;
  }
}

} // namespace

void
classifyLevels(std::vector<Level>& levels, const LevelParameters& parameters)
{
  std::vector<CellSet> coarse(levels.size());
  parallelBlocks(levels.size(), 1, parameters.threads, [&](std::size_t l, std::size_t) {
    coarse[l] = coarsened(levels[l].cells, parameters);
    levels[l].kind = LevelKind::Other;
  });
  std::vector<CeilingPart> ceilings(levels.size());
  parallelBlocks(levels.size(), 1, parameters.threads, [&](std::size_t l, std::size_t) {
    ceilings[l] = ceilingOf(levels, coarse, l, parameters);
  });
  for (std::size_t l = 0; l < levels.size(); ++l) {
    if (ceilings[l].is_any)
      levels[l].kind = LevelKind::Ceiling;
    if (!ceilings[l].alone.empty())
      levels[l].cells = levels[l].within = std::move(ceilings[l].alone);
  }
  for (const CeilingRegion& region : ceilingRegions(levels, parameters))
    markFloorsBelow(levels, coarse, region, parameters);
}

} // namespace pcl::sedr
