// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <vector>

namespace pcl {
namespace sedr {

/** @brief What is between the faces of walls of which both were seen: the outline of
 * each, and of a wall all around a room its hole. The walls are those of the IFC model,
 * without their assumed thickness and without their mitres. */
std::vector<std::vector<PlanLoop>> wallBodies(const Floorplan& plan);

} // namespace sedr
} // namespace pcl
