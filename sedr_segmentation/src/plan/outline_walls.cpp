// SPDX-License-Identifier: BSD-3-Clause
#include "outline_walls.h"

#include "../profiles/cell_count.h"

namespace pcl::sedr {

double
OutlineWalls::topAroundGap(Cell cell) const
{
  return columns_.topAround(cell, cellsFor(2 * priors_.evidence_cell, grid().size()));
}

bool
OutlineWalls::isVertical(Cell cell) const
{
  return columns_.upperShare(cell, columns_.topAround(cell, 2), priors_.surface_band,
                             0) >= priors_.share_clear;
}

bool
OutlineWalls::isWallUpTo(Cell cell, double top) const
{
  return columns_.reaches(cell, top, gap_) &&
         columns_.upperShare(cell, top, priors_.surface_band, 1) >= priors_.share_clear;
}

bool
OutlineWalls::isWall(Cell cell) const
{
  return isWallUpTo(cell, columns_.topAround(cell, 2));
}

bool
OutlineWalls::isPartition(Cell cell) const
{
  return isWallUpTo(cell, topAroundGap(cell));
}

bool
OutlineWalls::isFloorToCeiling(Cell cell) const
{
  const double top = topAroundGap(cell);
  const double floor = columns_.floorAt(cell);
  const double band = priors_.surface_band;
  return isWallUpTo(cell, top) &&
         columns_.table().share(cell, floor + band, top - band, 10, 1) >=
             priors_.share_half &&
         isSurface(cell, columns_.middleBelow(cell, top), top - band);
}

bool
OutlineWalls::isSurface(Cell cell, double low, double high) const
{
  const int parts = cellsFor(high - low, grid().size());
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx)
      if (columns_.table().share({cell.x + dx, cell.y + dy}, low, high, parts, 0) >=
          priors_.share_half)
        return true;
  return false;
}

bool
OutlineWalls::isLargeEnough(std::size_t cells) const
{
  return static_cast<double>(cells) * grid().size() * grid().size() >=
         priors_.min_column_area;
}

bool
OutlineWalls::isColumn(const CellMask& hole) const
{
  if (!isLargeEnough(hole.count()))
    return false;
  const CellMask own = cropped(hole, boxOf(hole.toSet()));
  const CellMask rim = subtract(own, eroded(own, 1));
  std::size_t walled = 0;
  for (std::size_t i = 0; i < rim.values().size(); ++i)
    walled += rim.values()[i] && isFloorToCeiling(rim.cellAt(i)) ? 1 : 0;
  return static_cast<double>(walled) >=
         priors_.share_part * static_cast<double>(rim.count());
}

double
OutlineWalls::wallShare(const CellMask& part, const CellMask& other) const
{
  std::size_t edges = 0;
  std::size_t walls = 0;
  for (std::size_t i = 0; i < part.values().size(); ++i) {
    if (!part.values()[i])
      continue;
    const Cell cell = part.cellAt(i);
    const bool is_edge =
        other.at({cell.x + 1, cell.y}) || other.at({cell.x - 1, cell.y}) ||
        other.at({cell.x, cell.y + 1}) || other.at({cell.x, cell.y - 1});
    if (!is_edge)
      continue;
    ++edges;
    walls += isWall(cell) ? 1 : 0;
  }
  return edges == 0 ? 0 : static_cast<double>(walls) / static_cast<double>(edges);
}

} // namespace pcl::sedr
