// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/point_view.h>

#include <Eigen/Core>

#include <vector>

namespace pcl::sedr {

/** @brief A cube whose points lie on a plane. */
struct PlanePatch {
  Eigen::Vector3d middle; ///< mean of its points
  Eigen::Vector3d normal; ///< unit, z not below 0
  double count = 0;       ///< of its points
  double scatter = 0;     ///< standard deviation normal to the plane, metres
};

/** @brief Returns the cubes of `patch` metres whose points, rotated by `turn`, lie on a
 * plane. The cubes are shifted by `offset` patches along all axes. O(n log n); the
 * result does not depend on the number of threads.
 * @param max_scatter normal to the plane, metres */
std::vector<PlanePatch> planesOf(const PointView& points,
                                 const std::vector<int>& indices,
                                 const Eigen::Matrix3d& turn,
                                 double patch,
                                 unsigned threads,
                                 double offset = 0,
                                 double max_scatter = 0.02);

} // namespace pcl::sedr
