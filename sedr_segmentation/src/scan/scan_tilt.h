// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/priors.h>

#include <Eigen/Core>

#include <vector>

namespace pcl::sedr {

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
