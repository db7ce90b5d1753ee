// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <Eigen/Core>

namespace pcl::sedr {

/** @brief Returns the straight element from `start` to `end`. */
inline PlanElement
segment(const Eigen::Vector2d& start, const Eigen::Vector2d& end)
{
  PlanElement e;
  e.start = start;
  e.end = end;
  return e;
}

} // namespace pcl::sedr
