// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <algorithm>

namespace pcl {
namespace sedr {

inline double
cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

/** @brief Whether an arc is a whole circle. */
inline bool
isWhole(const PlanElement& arc)
{
  return (arc.start - arc.end).norm() <= 1e-9 * std::max(1.0, arc.radius);
}

} // namespace sedr
} // namespace pcl
