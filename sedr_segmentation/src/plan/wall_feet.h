// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../faces/room_cells.h"
#include <pcl/sedr_filters/floorplan.h>

namespace pcl::sedr {

/** @brief Moves those straight walls of a room that lean by more than 1.5 degrees from
 * where they meet the ceiling to their feet, with their tilts. adjustPlan() decides
 * whether they stay so, and of smaller tilts.
 *
 * Patches that cover 1.5 m2 and 1.5 m of height, and begin within 1 m of the floor,
 * must be on the wall: higher ones are roof slopes.
 * @param[in,out] room with its walls at the ceiling, and the plane of its floor */
void moveToFeet(const WallSlopes& slopes,
                const CellGrid& grid,
                const RoomCells& cells,
                PlanRoom& room);

} // namespace pcl::sedr
