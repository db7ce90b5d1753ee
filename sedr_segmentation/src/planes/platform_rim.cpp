// SPDX-License-Identifier: BSD-3-Clause
#include "platform_rim.h"

#include "../profiles/cell_count.h"

namespace pcl::sedr {

namespace {

bool
isNear(const CellSet& cells, Cell cell)
{
  return anyAround(cells, cell, 3, [](std::size_t) { return true; });
}

} // namespace

bool
PlatformStep::isWall(Cell cell) const
{
  const double top = topAt(cell);
  return columns.share(cell, top + 0.2, top + 1.4, 8, 2) >= 0.6;
}

bool
PlatformStep::isFurnished(Cell cell) const
{
  const double top = topAt(cell);
  return columns.share(cell, top + 0.1, top + 0.5, 4, 2) >= 0.75;
}

bool
PlatformStep::isRiser(Cell cell) const
{
  const double low = treadAt(cell) + 0.03;
  const double high = topAt(cell) - 0.03;
  const int bins = cellsFor(high - low, 0.08);
  return columns.share(cell, low, high, bins, 1) >= 0.5;
}

double
PlatformStep::treadAt(Cell cell) const
{
  double height = floorAt(cell);
  for (const Level& tread : levels) {
    const double z = tread.slab.heightAt(grid.centre(cell));
    if (z > height && z < topAt(cell) - priors.min_floor_step &&
        isNear(tread.cells, cell))
      height = z;
  }
  return height;
}

bool
isLargerThanFurniture(const CellMask& region, double cell_size, const Priors& priors)
{
  return static_cast<double>(region.count()) * cell_size * cell_size >
         priors.max_furniture_area;
}

bool
isClosed(const PlatformStep& step, const CellMask& region)
{
  const CellMask rim = subtract(region, eroded(region, 1));
  const CellMask near_higher = dilated(step.higher, 3);
  std::size_t walls = 0;
  std::size_t risers = 0;
  std::size_t hidden = 0;
  for (std::size_t i = 0; i < rim.values().size(); ++i) {
    if (!rim.values()[i])
      continue;
    const Cell cell = rim.cellAt(i);
    if (near_higher.at(cell) || step.isWall(cell))
      ++walls;
    else if (step.isFurnished(cell))
      ++hidden;
    else if (step.isRiser(cell))
      ++risers;
  }
  const std::size_t all = rim.count();
  return (isLargerThanFurniture(region, step.grid.size(), step.priors) ||
          5 * walls >= all - hidden) &&
         10 * (walls + hidden + risers) >= 7 * all;
}

} // namespace pcl::sedr
