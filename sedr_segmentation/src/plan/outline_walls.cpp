// SPDX-License-Identifier: BSD-3-Clause
#include "outline_walls.h"

#include "../profiles/cell_count.h"

namespace pcl {
namespace sedr {

namespace {

/** @brief Smallest hole that may be a column, square metres: 17 cm by 17 cm. */
constexpr double least_column_area = 0.03;

/** @brief Share of the upper half of a column that a wall fills. */
constexpr double least_upper_share = 0.6;

} // namespace

double
OutlineWalls::topAroundGap(Cell cell) const
{
  return columns_.topAround(cell, cellsFor(2 * outline_gap, grid().size()));
}

bool
OutlineWalls::isUpright(Cell cell) const
{
  return columns_.upperShare(cell, columns_.topAround(cell, 2), 0.1, 0) >=
         least_upper_share;
}

bool
OutlineWalls::isWallUpTo(Cell cell, double top) const
{
  return columns_.reaches(cell, top, gap_) &&
         columns_.upperShare(cell, top, 0.1, 1) >= least_upper_share;
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
  return isWallUpTo(cell, top) &&
         columns_.table().share(cell, floor + 0.1, top - 0.1, 10, 1) >= 0.5 &&
         isSurface(cell, columns_.middleBelow(cell, top), top - 0.1);
}

bool
OutlineWalls::isSurface(Cell cell, double low, double high) const
{
  constexpr double least_share = 0.5;
  const int parts = cellsFor(high - low, grid().size());
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx)
      if (columns_.table().share({cell.x + dx, cell.y + dy}, low, high, parts, 0) >=
          least_share)
        return true;
  return false;
}

bool
OutlineWalls::isLargeEnough(std::size_t cells) const
{
  return static_cast<double>(cells) * grid().size() * grid().size() >=
         least_column_area;
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
  return 5 * walled >= 2 * rim.count();
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

} // namespace sedr
} // namespace pcl
