// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "picture.h"

#include <pcl/sedr_filters/floorplan.h>

namespace pcl::sedr::tools {

/** @brief Adds the walls, columns and details of all rooms, segments and arcs in
 * different colours. */
void addPlan(const Floorplan& plan, double pixels, Panel& panel);

/** @brief Adds the number of each room and its area, deep inside it. */
void addRoomNumbers(const Floorplan& plan, Panel& panel);

/** @brief Adds the legend of addPlan() for the elements in the plan. */
void addPlanLegend(const Floorplan& plan, Picture& picture);

/** @brief Returns the extent of all rooms with `margin` metres around. */
Box viewOf(const Floorplan& plan, double margin);

} // namespace pcl::sedr::tools
