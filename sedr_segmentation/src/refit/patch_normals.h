// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/point_view.h>

#include <Eigen/Core>

#include <vector>

namespace pcl {
namespace sedr {

/** @brief A cube whose points are a plane. */
struct PlanePatch {
  Eigen::Vector3d middle; ///< mean of its points
  Eigen::Vector3d normal; ///< unit, z not below 0
  double count = 0;       ///< of its points
};

/** @brief The cubes of `patch` metres whose points are a plane, turned by `turn`, as
 * normalsOf() has them. */
std::vector<PlanePatch> planesOf(const PointView& points,
                                 const std::vector<int>& indices,
                                 const Eigen::Matrix3d& turn,
                                 double patch,
                                 unsigned threads,
                                 double offset = 0);

/** @brief The normals of the cubes of `patch` metres whose points are a plane, z not
 * below 0, all turned by `turn`; the cubes lie `offset` patches off along all axes.
 * O(n log n); the same for any number of threads. */
std::vector<Eigen::Vector3d> normalsOf(const PointView& points,
                                       const std::vector<int>& indices,
                                       const Eigen::Matrix3d& turn,
                                       double patch,
                                       unsigned threads,
                                       double offset = 0);

} // namespace sedr
} // namespace pcl
