// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <cmath>
#include <cstddef>
#include <optional>

namespace pcl::sedr {

constexpr double no_opening = 0.05; ///< width and height up to which it is none, metres

/** @brief Returns the element of a room's boundary that is nearest to an opening,
 * within 30 degrees and half a metre of its faces; nothing if there is none. */
inline std::optional<std::size_t>
wallBeside(const PlanRoom& room, const PlanOpening& opening)
{
  constexpr double reach = 0.5;    // metres
  constexpr double parallel = 0.5; // sine of 30 degrees
  const Eigen::Vector2d middle = (opening.start + opening.end) / 2;
  const Eigen::Vector2d way = (opening.end - opening.start).normalized();
  double nearest = opening.depth / 2 + reach;
  std::optional<std::size_t> wall;
  for (std::size_t e = 0; e < room.boundary.elements.size(); ++e) {
    const PlanElement& element = room.boundary.elements[e];
    const double distance = element.distance(middle);
    if (distance < nearest &&
        std::abs(element.normalAt(element.project(middle)).dot(way)) < parallel) {
      nearest = distance;
      wall = e;
    }
  }
  return wall;
}

} // namespace pcl::sedr
