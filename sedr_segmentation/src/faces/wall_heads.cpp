// SPDX-License-Identifier: BSD-3-Clause
// Where walls that lean meet the ceiling.
#include "room_cells.h"

#include <algorithm>

namespace pcl::sedr {

namespace {

/** @brief Checks whether ceiling was seen in a cell or beside it, so that its height is
 * known. */
bool
isBesideSeen(const CellMask& seen, Cell cell)
{
  constexpr int reach = 3; // cells, less than RoomCellsParameters::local
  for (int dy = -reach; dy <= reach; dy += reach)
    for (int dx = -reach; dx <= reach; dx += reach)
      if (seen.at({cell.x + dx, cell.y + dy}) != 0)
        return true;
  return false;
}

} // namespace

Eigen::Vector2d
atCeiling(const Eigen::Vector3d& p,
          const Eigen::Vector2d& run,
          const CellGrid& grid,
          const RoomCells& room)
{
  constexpr double step = 0.02;    // metres up
  constexpr double max_higher = 3; // than the usual ceiling
  const Eigen::Vector2d own = p.head<2>();
  if (run.isZero())
    return own;
  // Up to the ceiling that was seen last: a wall that leans out leaves it at its head.
  bool is_below = false;
  double top = room.ceiling;
  for (double up = 0; p.z() + up < room.ceiling + max_higher; up += step) {
    const Eigen::Vector2d place = own + up * run;
    if (!grid.holds(place.x(), place.y()))
      break;
    if (const Cell cell = grid.at(place.x(), place.y());
        room.seen.isInside(cell) && isBesideSeen(room.seen, cell)) {
      is_below = true;
      top = static_cast<double>(room.top[room.seen.indexOf(cell)]);
    }
    if (is_below && p.z() + up >= top)
      return own + std::max(0.0, top - p.z()) * run;
  }
  return own + std::max(0.0, room.ceiling - p.z()) * run;
}

Eigen::Vector2d
placeInPlan(const Eigen::Vector3d& p,
            const WallSlopes& slopes,
            const CellGrid& grid,
            const RoomCells& room)
{
  constexpr double reach = 1; // metres up: twice the band in which walls are looked for
  const Eigen::Vector2d run = slopes.at(p);
  const Eigen::Vector2d place = atCeiling(p, run, grid, room);
  const Eigen::Vector2d own = p.head<2>();
  return (place - own).norm() < reach * run.norm() ? place : own;
}

} // namespace pcl::sedr
