// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/tilted_walls.h>

#include <vector>

namespace pcl::sedr {

/** @brief Returns where a point would be if all walls stood vertical at their heads.
 *
 * At every height a point on a face moves with it to its line at the head. The space
 * beside a face moves with it, less with the distance, up to a metre more than the face
 * moves. Vertical faces stay and hold what is beside them. O(faces). */
Eigen::Vector3d upright(const std::vector<TiltedFace>& faces, const Eigen::Vector3d& p);

/** @brief Tilts the walls of a plan that was fitted to upright() points. A wall on a
 * tilted face becomes the foot of the face; corners are the intersections of walls at
 * the floor. adjustPlan() fits the tilts. */
void tiltWalls(const std::vector<TiltedFace>& faces, Floorplan& plan);

} // namespace pcl::sedr
