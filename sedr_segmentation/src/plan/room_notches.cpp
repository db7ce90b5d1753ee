// SPDX-License-Identifier: BSD-3-Clause
#include "room_notches.h"

#include "../curves/strip.h"

#include "../profiles/cell_count.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace pcl::sedr {

namespace {

/** @brief Returns the share of a notch's width with a wall behind its mouth. The faces
 * of a pilaster end at the wall, and there is none behind.
 * @param outer cells of the notch at its mouth in the wall
 * @param outside cells beyond the mouth */
double
wallBehind(const CellMask& notch,
           const CellMask& outer,
           const CellMask& outside,
           const OutlineWalls& walls)
{
  const CellGrid& grid = walls.grid();
  constexpr double margin = 2;   // cells at both ends, which contain the faces
  constexpr double farthest = 4; // cells from the mouth to the wall
  const Strip mouth = stripOf(outer, grid);
  if (mouth.width > 3 * grid.size()) // the mouth is at a corner of the wall
    return 0;
  const Eigen::Vector2d along = mouth.direction / grid.size();
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (std::size_t i = 0; i < notch.values().size(); ++i)
    if (notch.values()[i]) {
      const double s = along.dot(grid.centre(notch.cellAt(i)));
      low = std::min(low, s);
      high = std::max(high, s);
    }
  const double first = low + margin;
  const double width = high - margin - first;
  if (width < 1)
    return 0;
  std::vector<std::uint8_t> is_walled(static_cast<std::size_t>(width) + 1, 0);
  const CellMask near = intersect(dilated(outer, farthest), outside);
  for (std::size_t i = 0; i < near.values().size(); ++i) {
    if (!near.values()[i] || !walls.isVertical(near.cellAt(i)))
      continue;
    const double s = along.dot(grid.centre(near.cellAt(i))) - first;
    if (s >= 0 && s <= width)
      is_walled[static_cast<std::size_t>(s)] = 1;
  }
  return static_cast<double>(std::count(is_walled.begin(), is_walled.end(), 1)) /
         static_cast<double>(is_walled.size());
}

/** @brief Returns the column in a notch, including its shadow, if the wall of the room
 * continues behind the notch; else nothing. */
CellMask
columnBeforeWall(const CellMask& notch,
                 const CellMask& closed,
                 const OutlineWalls& walls)
{
  const CellMask nothing(notch.box());
  if (!walls.isLargeEnough(notch.count()))
    return nothing;
  const CellMask outside = inverted(closed);
  const CellMask outer = intersect(notch, dilated(outside, 1));
  if (outer.count() == 0 ||
      wallBehind(notch, outer, outside, walls) < walls.priors().share_clear)
    return nothing;
  const CellMask column = largestRegion(subtract(notch, outer));
  return walls.isColumn(column) ? column : nothing;
}

} // namespace

CellMask
withoutFalseNotches(const CellMask& room,
                    const OutlineWalls& walls,
                    std::vector<CellMask>& columns)
{
  const double radius = cellsFor(walls.priors().max_pilaster, walls.grid().size());
  CellMask closed = eroded(dilated(room, radius), radius);
  closed = unite(closed, enclosedCells(closed));
  const CellMask notches = subtract(closed, room);
  const MaskRegions regions = labelRegions(notches, false);
  CellMask result = room;
  for (std::size_t r = 0; r < regions.sizes.size(); ++r) {
    const CellMask notch = regionMask(notches, regions, static_cast<std::int32_t>(r));
    const bool is_false = walls.wallShare(notch, room) < walls.priors().share_half;
    const CellMask column =
        is_false ? CellMask() : columnBeforeWall(notch, closed, walls);
    if (column.count() > 0)
      columns.push_back(column);
    if (is_false || column.count() > 0)
      result = unite(result, notch);
  }
  return result;
}

} // namespace pcl::sedr
