// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <vector>

namespace pcl::sedr {

/** @brief Returns the bodies of walls with both faces seen: the outline of each, and
 * the hole of a wall that surrounds a room. These are the walls of the IFC model
 * without mitres; walls of assumed thickness are omitted. */
std::vector<std::vector<PlanLoop>> wallBodies(const Floorplan& plan, double max_wall);

} // namespace pcl::sedr
