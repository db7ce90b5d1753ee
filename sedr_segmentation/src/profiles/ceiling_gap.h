// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <algorithm>

namespace pcl {
namespace sedr {

/** @brief The band below a ceiling, metres under it, that a wall crosses and a cupboard
 * does not reach: it begins where the ceiling's own noise ends and is so wide that
 * every wall of voxels has a point in it. A gap of less than `low` cannot be told. */
struct CeilingGap {
  double high = 0.03;
  double low = 0.085;
};

/** @brief The band below a ceiling of that noise: four standard deviations of its
 * points, at least 3 cm and at most 10 cm. */
inline CeilingGap
gapBelow(const PlanSlab& ceiling)
{
  const CeilingGap least;
  const double high = std::clamp(4 * ceiling.residual, least.high, 0.1);
  return {high, high + least.low - least.high};
}

} // namespace sedr
} // namespace pcl
