// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <Eigen/Geometry>

namespace pcl::sedr {

/** @brief Returns the bounding box of a loop; empty without elements. Exact for arcs.
 * O(n). */
inline Eigen::AlignedBox2d
boundsOf(const PlanLoop& loop)
{
  Eigen::AlignedBox2d box;
  for (const PlanElement& e : loop.elements) {
    box.extend(e.start);
    // The extremes of an arc are quarters of its circle.
    for (const Eigen::Vector2d& way :
         {Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 1), Eigen::Vector2d(-1, 0),
          Eigen::Vector2d(0, -1)}) {
      const Eigen::Vector2d quarter = e.centre + e.radius * way;
      if (e.isArc() && e.distance(quarter) < 1e-9 * (1 + e.radius))
        box.extend(quarter);
    }
  }
  return box;
}

} // namespace pcl::sedr
