// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan_area.h"
#include "sedr_filters/src/walls/plan_walls.h"

namespace pcl::sedr {

/** @brief Returns the side of a wall behind its face, in the direction of the face. */
PlanElement farSideOf(const Floorplan& plan, const PlanWall& wall);

/** @brief Returns what is between the face of a wall and its far side,
 * counter-clockwise; a wall that surrounds a room has a hole. */
PlanArea bandOf(const Floorplan& plan, const PlanWall& wall);

/** @brief Checks whether a wall is an outer one: only one face of it was seen, and a
 * window leads out of it, or there is no room of its heights within 3 m behind most of
 * it. */
bool isExternal(const Floorplan& plan, const PlanWall& wall);

} // namespace pcl::sedr
