// SPDX-License-Identifier: BSD-3-Clause
#include "platform_rim.h"

#include "floor_platforms.h"

#include "../profiles/cell_count.h"
#include "sedr_filters/src/base/exactness.h"
#include "sedr_filters/src/grids/cell_mask.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>

namespace pcl::sedr {

namespace {

/** @brief Returns whether the floor is seen below more than a tenth of the region,
 * without its rim. */
bool
hasFloorBelow(const Level& floor, const CellMask& region)
{
  const CellMask inside = eroded(region, 2);
  return 10 * intersect(CellMask(floor.cells, region.box()), inside).count() >
         inside.count();
}

/** @brief Returns the part of a region that has the given minimum width. */
CellMask
widePart(const CellMask& region, double width, double cell_size)
{
  const double radius = cellsFor(width / 2, cell_size);
  return intersect(region, dilated(eroded(region, radius), radius));
}

/** @brief Returns the lower floor with the most cells beside a region, or null if the
 * step to it is not a platform's. */
const Level*
floorBeside(const CellMask& region,
            const Level& level,
            const std::vector<const Level*>& floors,
            const CellGrid& grid,
            const Priors& priors)
{
  const CellMask beside =
      subtract(dilated(region, cellsFor(priors.max_wall, grid.size())), region);
  const CellBox& box = region.box();
  const Eigen::Vector2d middle = (grid.centre(box.low) + grid.centre(box.high)) / 2;
  const auto stepUpFrom = [&](const Level& floor) {
    return level.slab.heightAt(middle) - floor.slab.heightAt(middle);
  };
  const Level* best = nullptr;
  std::size_t most = 0;
  for (const Level* floor : floors) {
    const std::size_t cells = intersect(CellMask(floor->cells, box), beside).count();
    if (cells <= most || stepUpFrom(*floor) <= 0)
      continue;
    most = cells;
    best = floor;
  }
  const bool is_platform = best != nullptr &&
                           stepUpFrom(*best) >= priors.min_floor_step &&
                           stepUpFrom(*best) <= priors.max_platform_height;
  return is_platform ? best : nullptr;
}

/** @brief Returns whether a region can be reached by a step from the floor or from a
 * tread at least 0.4 m long at its rim. A stage larger than furniture has steps
 * somewhere, even if they are too small for a level. */
bool
isWithinAStep(const CellMask& region,
              const Level& level,
              const Level& floor,
              const std::vector<Level>& levels,
              const CellGrid& grid,
              const Priors& priors)
{
  const CellBox& box = region.box();
  const Eigen::Vector2d middle = (grid.centre(box.low) + grid.centre(box.high)) / 2;
  const double top = level.slab.heightAt(middle);
  const double bottom = floor.slab.heightAt(middle);
  if (top - bottom <= priors.max_step_height ||
      isLargerThanFurniture(region, grid.size(), priors))
    return true;
  const CellMask rim = subtract(dilated(region, 2), region);
  const auto least = static_cast<std::size_t>(cellsFor(0.4, grid.size()));
  return std::any_of(levels.begin(), levels.end(), [&](const Level& tread) {
    const double height = tread.slab.heightAt(middle);
    return top - height <= priors.max_step_height &&
           top - height >= priors.min_floor_step &&
           height - bottom >= priors.min_floor_step &&
           height - bottom <= priors.max_step_height &&
           intersect(CellMask(tread.cells, box), rim).count() >= least;
  });
}

/** @brief Returns whether a level may have a platform's height above a floor anywhere
 * in a box. The height difference of two planes is extreme at the corners. */
bool
mayStepUp(const Level& level,
          const Level& floor,
          const CellBox& box,
          const CellGrid& grid,
          const Priors& priors)
{
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -lowest;
  for (const std::int32_t x : {box.low.x, box.high.x})
    for (const std::int32_t y : {box.low.y, box.high.y}) {
      const Eigen::Vector2d corner = grid.centre({x, y});
      const double step = level.slab.heightAt(corner) - floor.slab.heightAt(corner);
      lowest = std::min(lowest, step);
      highest = std::max(highest, step);
    }
  return lowest <= priors.max_platform_height + same_place &&
         highest >= priors.min_floor_step - same_place;
}

/** @brief Returns the cells of the platforms of `level` above one of `floors`. `higher`
 * are the platforms found so far; `steps_up` returns further cells a step above and is
 * rarely called. */
CellSet
platformCells(const Level& level,
              const std::vector<Level>& levels,
              const std::vector<const Level*>& floors,
              const CellSet& higher,
              const std::function<CellSet()>& steps_up,
              const PointView& points,
              const std::vector<int>& indices,
              const LevelParameters& parameters)
{
  const Priors& priors = parameters.priors;
  const double cell_size = parameters.cell_size;
  const CellGrid grid(cell_size);
  const auto least = static_cast<std::size_t>(
      cellsFor(priors.min_platform_area / cell_size, cell_size));
  const int margin = cellsFor(priors.min_platform_width, cell_size);
  const CellBox all = grown(boxOf(level.cells), margin);
  if (std::none_of(floors.begin(), floors.end(), [&](const Level* floor) {
        return mayStepUp(level, *floor, all, grid, priors);
      }))
    return {};
  CellSet found;
  for (const CellSet& cells : connectedRegions(level.cells)) {
    if (cells.size() < least / 2)
      continue;
    const CellBox box = grown(boxOf(cells), margin);
    if (!maskProblem(box).empty())
      continue;
    // Objects on a platform hide parts of it.
    const CellMask closed = eroded(dilated(CellMask(cells, box), 2), 2);
    const CellMask above = intersect(dilated(CellMask(higher, box), 3), closed);
    const CellMask whole = unite(closed, enclosedCells(closed));
    if (whole.count() < least)
      continue;
    const CellMask region = widePart(
        whole, above.count() > 0 ? priors.min_tread : priors.min_platform_width,
        cell_size);
    const Level* floor = region.count() < least
                             ? nullptr
                             : floorBeside(region, level, floors, grid, priors);
    const bool is_table =
        floor != nullptr &&
        std::any_of(floors.begin(), floors.end(), [&](const Level* f) {
          return f->height < level.height && hasFloorBelow(*f, region);
        });
    if (floor == nullptr || is_table ||
        !isWithinAStep(region, level, *floor, levels, grid, priors))
      continue;
    const PlatformStep step{level,
                            *floor,
                            grid,
                            ColumnTable(grid, box, points, indices, parameters.threads),
                            unite(CellMask(higher, box), CellMask(steps_up(), box)),
                            levels,
                            priors};
    if (isClosed(step, region))
      found = unite(found, region.toSet());
  }
  return found;
}

std::vector<const Level*>
floorsOf(const std::vector<Level>& levels)
{
  std::vector<const Level*> floors;
  for (const Level& level : levels)
    if (level.kind == LevelKind::Floor)
      floors.push_back(&level);
  return floors;
}

/** @brief Returns the wide parts of levels that are a step above `level`. */
CellSet
stepsUpFrom(const Level& level,
            const std::vector<Level>& levels,
            double cell_size,
            const Priors& priors)
{
  CellSet steps;
  for (const Level& other : levels) {
    const double rise = other.height - level.height;
    if (other.kind == LevelKind::Ceiling || other.cells.empty() ||
        rise < priors.min_floor_step || rise > priors.max_step_height)
      continue;
    const CellBox box = grown(boxOf(other.cells), cellsFor(0.2, cell_size));
    if (maskProblem(box).empty())
      steps = unite(steps, widePart(CellMask(other.cells, box),
                                    priors.min_platform_width, cell_size)
                               .toSet());
  }
  return steps;
}

} // namespace

void
markPlatforms(std::vector<Level>& levels,
              const PointView& points,
              const std::vector<int>& indices,
              const LevelParameters& parameters)
{
  CellSet found;
  const auto tryLevel = [&](Level& level, const std::function<CellSet()>& steps_up) {
    const CellSet cells = platformCells(level, levels, floorsOf(levels), found,
                                        steps_up, points, indices, parameters);
    if (cells.empty())
      return;
    found = unite(found, cells);
    level.kind = LevelKind::Floor;
    level.within = cells;
  };
  // From the highest to the lowest: a step is recognised by the platform above it.
  for (std::size_t l = levels.size(); l-- > 0;)
    if (levels[l].kind == LevelKind::Other)
      tryLevel(levels[l], [] { return CellSet(); });
  // From the lowest to the highest: of tiers of seats, only the first is on the floor.
  for (auto& level : levels)
    if (level.kind == LevelKind::Other)
      tryLevel(level, [&] {
        return stepsUpFrom(level, levels, parameters.cell_size, parameters.priors);
      });
}

} // namespace pcl::sedr
