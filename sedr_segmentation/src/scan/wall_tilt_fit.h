// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/straightening.h>

#include <vector>

namespace pcl::sedr {

/** @brief Tilts the walls of a plan that was fitted in the frame of vertical walls. A
 * wall on a tilted face becomes the foot of the face; corners are the intersections of
 * walls at the floor. Details move with them. adjustPlan() fits the tilts.
 * @param map transformation to the frame of vertical walls
 * @param faces wall faces of the map
 * @param[in,out] plan with vertical walls on input, with feet and tilts on output */
void tiltWalls(const Straightening& map,
               const std::vector<TiltedFace>& faces,
               Floorplan& plan);

} // namespace pcl::sedr
