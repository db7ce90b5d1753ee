// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/tilted_walls.h>

#include <vector>

namespace pcl::sedr {

/** @brief Tilts the walls of a plan that was fitted to withVerticalWalls() points. A
 * wall on a tilted face becomes the foot of the face; corners are the intersections of
 * walls at the floor. adjustPlan() fits the tilts. */
void tiltWalls(const std::vector<TiltedFace>& faces, Floorplan& plan);

} // namespace pcl::sedr
