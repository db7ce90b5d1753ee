// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/priors.h>

#include <Eigen/Core>

#include <vector>

namespace pcl::sedr {

/** @brief Orientation of a scan relative to z. */
struct ScanInclination {
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ(); ///< unit normal of its floors
  double angle = 0; ///< between `up` and z, radians; 0 if the scan is not tilted
  double area = 0;  ///< area of the planes normal to `up`, square metres
};

/** @brief Finds the tilt of a scan as a whole, 3 to 45 degrees. Most planes closer to
 * level than to vertical must share one normal direction, and few be normal to z. The
 * walls must be parallel to that direction rather than to z, so a sloping roof between
 * vertical walls is no tilt. For thinned points; uses half-metre patches, O(n log n).
 * @param threads 0: all processors */
ScanInclination inclinationOf(const PointView& points,
                              const std::vector<int>& indices,
                              unsigned threads = 1,
                              const Priors& priors = {});

} // namespace pcl::sedr
