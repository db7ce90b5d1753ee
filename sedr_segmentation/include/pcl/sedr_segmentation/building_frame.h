// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/scan_frame.h>

#include <Eigen/Core>

#include <vector>

namespace pcl::sedr {

/** @brief Finds the frame of a building, in which what is found on grids does not
 * depend on where and how its scan lies.
 *
 * The direction that most wall has (modulo 90 degrees, to a hundredth of a degree) and
 * the side to which the building extends most give its direction; the largest walls in
 * both directions and the largest level surface give its origin. Its axes lie half a
 * radian aside of the walls: these then cross the cells of a grid at all places, so
 * that what cells do to a wall averages out along it, while along an axis a whole wall
 * would depend on where in its cells it lies. Walls are told by what stands out from
 * the points around it, each voxel counting once. If no direction stands out, as in a
 * round room, the frame is that of the weak maximum; without walls, that of the scan.
 *
 * @code
 * const pcl::sedr::BuildingFrame frame =
 *     pcl::sedr::findBuildingFrame(pcl::sedr::PointView(*thinned), indices);
 * for (auto& p : *thinned)
 *   p.getVector3fMap() =
 *       frame.toBuilding(p.getVector3fMap().cast<double>()).cast<float>();
 * @endcode
 * O(n log n) for n points; the same for any number of threads.
 * @param points thinned, metres
 * @param indices the points to use; empty: all
 * @param level rotation that makes the scan level, see Levelling
 * @param cell edge of the cells of the stages that follow, metres
 * @param threads 0: all processors */
BuildingFrame
findBuildingFrame(const PointView& points,
                  const std::vector<int>& indices = {},
                  unsigned threads = 0,
                  const Eigen::Matrix3d& level = Eigen::Matrix3d::Identity(),
                  double cell = 0.05);

} // namespace pcl::sedr
