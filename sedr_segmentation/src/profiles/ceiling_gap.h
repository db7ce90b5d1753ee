// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <algorithm>

namespace pcl::sedr {

/** @brief A band below a ceiling, metres, that a wall crosses and a cupboard does not
 * reach. It begins below the ceiling's noise and is wide enough that every wall of
 * voxels has a point in it. Gaps of less than `low` cannot be detected. */
struct CeilingGap {
  double high = 0.03;
  double low = 0.085;
};

/** @brief Returns the band below a ceiling. It begins at four standard deviations of
 * the ceiling's points, at least 3 cm and at most 10 cm. */
inline CeilingGap
gapBelow(const PlanSlab& ceiling)
{
  const CeilingGap least;
  const double high = std::clamp(4 * ceiling.residual, least.high, 0.1);
  return {high, high + least.low - least.high};
}

} // namespace pcl::sedr
