// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <cstddef>
#include <vector>

namespace pcl::sedr {

/** @brief Checks whether any wall of a room is tilted. */
bool isTilted(const PlanRoom& room);

/** @brief Returns a room with the same feet and vertical walls. */
PlanRoom withVerticalWalls(PlanRoom room);

/** @brief Returns a wall of a room at height `z`. It ends where it meets the walls
 * beside it there. */
PlanElement wallAt(const PlanRoom& room, std::size_t wall, double z);

/** @brief Returns the boundary of a room at height `z`, with all walls at their
 * position there. If a wall has no length at that height, the loop crosses itself. */
PlanLoop boundaryAt(const PlanRoom& room, double z);

/** @brief Returns the maximum height of the top of a wall. */
double headOf(const PlanRoom& room, std::size_t wall);

/** @brief Returns the maximum height of the tops of a room's tilted walls. */
double headOf(const PlanRoom& room);

/** @brief Returns the boundary of a room with walls that tilt out of it at their heads
 * and all others at their feet: neither floor nor ceiling reaches farther. */
PlanLoop outermostBoundary(PlanRoom room);

/** @brief Returns the maximum distance of a room's walls from their feet in plan. */
double tiltReach(const PlanRoom& room);

/** @brief Moves the ends of moved elements and their neighbours to where they meet. */
void rejoin(PlanLoop& loop, const std::vector<bool>& is_moved);

} // namespace pcl::sedr
