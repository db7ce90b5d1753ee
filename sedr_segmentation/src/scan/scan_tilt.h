// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/priors.h>

#include <Eigen/Core>

#include <vector>

namespace pcl {
namespace sedr {

/** @brief How far a scan is off level. */
struct ScanTilt {
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ(); ///< along its walls, unit
  double angle = 0; ///< between that and z, radians; 0 where the scan is level
};

/** @brief Whether a scan is tilted as a whole, by 0.3 degrees or more, up to the 3 from
 * which leanOf() tells it. The walls say it: up is the direction that those of two
 * directions in plan are square to. Floors and ceilings must be tilted likewise: a
 * ceiling that slopes between vertical walls is no tilt, nor are walls that are out of
 * plumb between level floors. For thinned points; patches of half a metre are looked
 * at, O(n log n).
 * @param threads 0: as many as there are processors; any number gives the same */
ScanTilt tiltOf(const PointView& points,
                const std::vector<int>& indices,
                unsigned threads = 1,
                const Priors& priors = {});

} // namespace sedr
} // namespace pcl
