// SPDX-License-Identifier: BSD-3-Clause
#include "unseen_parts.h"

#include "../parting/wall_beside.h"

#include "sedr_filters/src/grids/cell_mask.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace pcl::sedr {

namespace {

/** @brief What ends a room's air in a direction. */
enum class End { Unseen, Wall, Opening };

End
endOf(const AirGaps& air, const AirGap& last, Cell cell, Cell by)
{
  for (int step = 0; step < wall_depth; ++step) {
    cell = moved(cell, by);
    const std::uint32_t column = air.columns().columnAt(cell);
    if (column == VoxelColumns::none)
      break;
    if (isWallAt(air, column, last))
      return End::Wall;
    if (air.goingOnFrom(last, column) != AirGaps::none)
      return End::Opening;
  }
  return End::Unseen;
}

} // namespace

void
measureUnseen(const AirGaps& air, double steps, BuildingRoom& room)
{
  const double cell = air.columns().cellSize();
  std::vector<CellKey> keys;
  for (const RoomColumn& c : room.columns)
    keys.push_back(keyOf(c.cell));
  const CellSet cells(std::move(keys));
  const CellBox box = grown(boxOf(cells), 1);
  const CellMask holes =
      maskProblem(box).empty() ? enclosedCells(CellMask(cells, box)) : CellMask();
  std::size_t unseen = 0;
  std::array<std::size_t, 3> ends{0, 0, 0};
  for (const RoomColumn& c : room.columns) {
    unseen += !c.floor_seen && !c.ceiling_seen ? 1 : 0;
    const AirGap gap{0, lowOf(air, c), highOf(air, c)};
    for (const Cell& by : plan_directions)
      if (!cells.contains(moved(c.cell, by)) && !holes.at(moved(c.cell, by)))
        ++ends[static_cast<std::size_t>(endOf(air, gap, c.cell, by))];
  }
  room.inferred = static_cast<double>(unseen) * cell * cell;
  const auto open = static_cast<double>(ends[static_cast<std::size_t>(End::Unseen)]);
  const auto walled = static_cast<double>(ends[static_cast<std::size_t>(End::Wall)]);
  room.unseen_outline = cell * open / steps;
  room.enclosure = open + walled == 0 ? 1 : walled / (open + walled);
}

} // namespace pcl::sedr
