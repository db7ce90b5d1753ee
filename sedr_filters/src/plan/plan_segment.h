// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

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

/** @brief Returns the loop of straight segments between corners. */
inline PlanLoop
loopOf(const std::vector<Eigen::Vector2d>& corners)
{
  PlanLoop loop;
  for (std::size_t k = 0; k < corners.size(); ++k)
    loop.elements.push_back(segment(corners[k], corners[(k + 1) % corners.size()]));
  return loop;
}

} // namespace pcl::sedr
