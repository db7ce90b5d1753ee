// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <Eigen/Geometry>

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

/** @brief Returns a direction turned by 90 degrees, counter-clockwise. */
inline Eigen::Vector2d
leftOf(const Eigen::Vector2d& way)
{
  return {-way.y(), way.x()};
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

/** @brief Returns the outline of a box. */
inline PlanLoop
loopAround(const Eigen::AlignedBox2d& box)
{
  const Eigen::Vector2d low = box.min();
  const Eigen::Vector2d high = box.max();
  return loopOf({low, {high.x(), low.y()}, high, {low.x(), high.y()}});
}

} // namespace pcl::sedr
