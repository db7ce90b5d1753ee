// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/priors.h>

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
 * plane, see normalsOf().
 * @param max_scatter normal to the plane, metres */
std::vector<PlanePatch> planesOf(const PointView& points,
                                 const std::vector<int>& indices,
                                 const Eigen::Matrix3d& turn,
                                 double patch,
                                 unsigned threads,
                                 double offset = 0,
                                 double max_scatter = 0.02);

/** @brief Returns the normals (z >= 0) of the cubes of `patch` metres whose points,
 * rotated by `turn`, lie on a plane. The cubes are shifted by `offset` patches along
 * all axes. O(n log n); the result does not depend on the number of threads. */
std::vector<Eigen::Vector3d> normalsOf(const PointView& points,
                                       const std::vector<int>& indices,
                                       const Eigen::Matrix3d& turn,
                                       double patch,
                                       unsigned threads,
                                       double offset = 0);

/** @brief Deviation of a scan from level. */
struct ScanTilt {
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ(); ///< unit, along its walls
  double angle = 0; ///< between `up` and z, radians; 0 if the scan is level
  double area = 0;  ///< of the planes perpendicular to `up`, square metres
};

/** @brief Finds the tilt of a scan as a whole, from 0.3 to 45 degrees. Up is the
 * direction, near z or near the commonest normal of planes closer to level than to
 * vertical, to which most walls are parallel, in at least two directions in plan.
 * Floors and ceilings must be tilted equally: a sloping roof between vertical walls is
 * no tilt, nor are tilted walls between level floors. For thinned points; uses patches
 * of half a metre, O(n log n).
 * @param threads 0: all processors; the result does not depend on it */
ScanTilt tiltOf(const PointView& points,
                const std::vector<int>& indices,
                unsigned threads = 1,
                const Priors& priors = {});

} // namespace pcl::sedr
