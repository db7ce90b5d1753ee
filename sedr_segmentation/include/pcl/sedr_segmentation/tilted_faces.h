// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/tilted_walls.h>

#include <vector>

namespace pcl::sedr {

/** @brief Finds the tilted wall faces of a scan, by 1 to 28 degrees, and the vertical
 * ones; empty if no wall is tilted.
 *
 * A face is a connected set of planar patches of 0.4 m in one plane. It must cover 1.5
 * m2 and 1.5 m of height and begin within 1 m of the floor in front of it; higher ones
 * are roof slopes. Each face is fitted to its points.
 * @param points thinned, level
 * @param threads 0: all processors; the result does not depend on it
 *
 * O(n log n). */
std::vector<TiltedFace> tiltedFaces(const PointView& points,
                                    const std::vector<int>& indices,
                                    unsigned threads = 1);

/** @brief Returns where a point would be if all walls were vertical, the plane of each
 * turned about its upper edge: points of a cloud moved so are what the stages before
 * FloorplanFitting work on, see FloorplanFitting::setTiltedWalls().
 *
 * At every height a point on a face moves with it to its upper edge in plan. The space
 * beside a face moves with it, less with the distance, up to a metre more than the face
 * moves. Vertical faces stay and hold what is beside them. Without faces a point stays;
 * one that is not finite stays so. O(faces). */
Eigen::Vector3d withVerticalWalls(const std::vector<TiltedFace>& faces,
                                  const Eigen::Vector3d& p);

} // namespace pcl::sedr
