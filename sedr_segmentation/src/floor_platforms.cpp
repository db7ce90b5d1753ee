// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_segmentation/floor_platforms.h>

#include <pcl/sedr_filters/cell_mask.h>
#include <pcl/sedr_segmentation/cell_count.h>
#include <pcl/sedr_segmentation/column_table.h>

#include <algorithm>

namespace pcl {
namespace sedr {

namespace {

/** @brief A level that may be a platform, and the floor below it. */
struct Step {
  const Level& level;
  const Level& floor;
  CellGrid grid;
  ColumnTable columns;
  CellMask higher; ///< platforms above this one

  double topAt(Cell cell) const { return level.slab.heightAt(grid.centre(cell)); }
  double floorAt(Cell cell) const { return floor.slab.heightAt(grid.centre(cell)); }

  /** @brief Whether a wall rises from the platform here. */
  bool isWall(Cell cell) const
  {
    const double top = topAt(cell);
    return columns.share(cell, top + 0.2, top + 1.4, 8, 2) >= 0.6;
  }

  /** @brief Whether something closes the platform down to the floor here. */
  bool isRiser(Cell cell) const
  {
    const double low = floorAt(cell) + 0.03;
    const double high = topAt(cell) - 0.03;
    const int bins = cellsFor(high - low, 0.08);
    return columns.share(cell, low, high, bins, 1) >= 0.5;
  }
};

/** @brief Whether the rim of a region is closed all around, in part by what rises from
 * it. */
bool
isClosed(const Step& step, const CellMask& region)
{
  const CellMask rim = subtract(region, eroded(region, 1));
  const CellMask near_higher = dilated(step.higher, 3);
  std::size_t walls = 0;
  std::size_t risers = 0;
  for (std::size_t i = 0; i < rim.values().size(); ++i) {
    if (!rim.values()[i])
      continue;
    const Cell cell = rim.cellAt(i);
    if (near_higher.at(cell) || step.isWall(cell))
      ++walls;
    else if (step.isRiser(cell))
      ++risers;
  }
  const std::size_t all = rim.count();
  return 5 * walls >= all && 10 * (walls + risers) >= 7 * all;
}

/** @brief Whether the floor is seen below a tenth of the region, its rim left out. */
bool
hasFloorBelow(const Level& floor, const CellMask& region)
{
  const CellMask inside = eroded(region, 2);
  return 10 * intersect(CellMask(floor.cells, region.box()), inside).count() >
         inside.count();
}

/** @brief The part of a region that is as wide as asked for. */
CellMask
widePart(const CellMask& region, double width, double cell_size)
{
  const double radius = cellsFor(width / 2, cell_size);
  return intersect(region, dilated(eroded(region, radius), radius));
}

/** @brief The platforms among the cells of `level`, above `floor`; `higher` are those
 * found already. */
CellSet
platformCells(const Level& level,
              const Level& floor,
              const CellSet& higher,
              const PointView& points,
              const std::vector<int>& indices,
              double cell_size,
              const PlatformParameters& platform)
{
  const CellGrid grid(cell_size);
  const auto least =
      static_cast<std::size_t>(cellsFor(platform.minimum_area / cell_size, cell_size));
  const CellRegions pieces = labelRegions(level.cells);
  std::vector<std::vector<CellKey>> keys(pieces.sizes.size());
  for (std::size_t i = 0; i < level.cells.size(); ++i)
    keys[pieces.label[i]].push_back(level.cells.keys()[i]);
  CellSet found;
  for (auto& k : keys) {
    const CellSet cells = CellSet::fromSorted(std::move(k));
    if (cells.size() < least / 2)
      continue;
    const CellBox box = grown(boxOf(cells), 6);
    if (!maskProblem(box).empty())
      continue;
    // What stands on a platform hides parts of it.
    const CellMask closed = eroded(dilated(CellMask(cells, box), 2), 2);
    const CellMask above = intersect(dilated(CellMask(higher, box), 3), closed);
    const CellMask region = widePart(
        unite(closed, enclosedCells(closed)),
        above.count() > 0 ? platform.minimum_tread : platform.minimum_width, cell_size);
    if (region.count() < least || hasFloorBelow(floor, region))
      continue;
    const Step step{level, floor, grid, ColumnTable(grid, box, points, indices),
                    CellMask(higher, box)};
    if (isClosed(step, region))
      found = unite(found, region.toSet());
  }
  return found;
}

/** @brief The floor that a level is a step above, or null. */
const Level*
floorBelow(const std::vector<Level>& levels,
           const std::vector<std::size_t>& floors,
           const Level& level,
           const PlatformParameters& platform)
{
  for (const std::size_t f : floors) {
    const double step = level.height - levels[f].height;
    if (step >= platform.least_height && step <= platform.greatest_height)
      return &levels[f];
  }
  return nullptr;
}

} // namespace

void
markPlatforms(std::vector<Level>& levels,
              const PointView& points,
              const std::vector<int>& indices,
              const LevelParameters& parameters,
              const PlatformParameters& platform)
{
  std::vector<std::size_t> floors;
  for (std::size_t l = 0; l < levels.size(); ++l)
    if (levels[l].kind == LevelKind::Floor)
      floors.push_back(l);
  CellSet found;
  // From the highest to the lowest: a step is told by the platform that it leads to.
  for (std::size_t l = levels.size(); l-- > 0;) {
    Level& level = levels[l];
    const Level* floor = level.kind == LevelKind::Other
                             ? floorBelow(levels, floors, level, platform)
                             : nullptr;
    if (floor == nullptr)
      continue;
    const CellSet cells = platformCells(level, *floor, found, points, indices,
                                        parameters.cell_size, platform);
    if (cells.empty())
      continue;
    found = unite(found, cells);
    level.kind = LevelKind::Floor;
    level.within = cells;
  }
}

} // namespace sedr
} // namespace pcl
