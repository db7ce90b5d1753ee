// SPDX-License-Identifier: BSD-3-Clause
#include "unseen_parts.h"

#include "../parting/wall_beside.h"

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace pcl::sedr {

namespace {

/** @brief Whether what ends a room's air in a direction was seen: a wall, or the air of
 * another part. */
bool
isEndSeen(const AirGaps& air, const AirGap& end, Cell cell, Cell by)
{
  for (int step = 0; step < wall_depth; ++step) {
    cell = moved(cell, by);
    const std::uint32_t column = air.columns().columnAt(cell);
    if (column == VoxelColumns::none)
      return false;
    if (isWallAt(air, column, end) || air.goingOnFrom(end, column) != AirGaps::none)
      return true;
  }
  return false;
}

} // namespace

void
measureUnseen(const AirGaps& air, BuildingRoom& room)
{
  const double cell = air.columns().cellSize();
  std::vector<CellKey> keys;
  for (const RoomColumn& c : room.columns)
    keys.push_back(keyOf(c.cell));
  const CellSet cells(std::move(keys));
  std::size_t unseen = 0;
  std::size_t ends = 0;
  for (const RoomColumn& c : room.columns) {
    unseen += !c.floor_seen && !c.ceiling_seen ? 1 : 0;
    const AirGap gap{0, lowOf(air, c), highOf(air, c)};
    for (const Cell& by : plan_directions)
      if (!cells.contains(moved(c.cell, by)))
        ends += isEndSeen(air, gap, c.cell, by) ? 0 : 1;
  }
  room.inferred = static_cast<double>(unseen) * cell * cell;
  room.unseen_outline = M_PI / 4 * cell * static_cast<double>(ends); // all directions
}

} // namespace pcl::sedr
