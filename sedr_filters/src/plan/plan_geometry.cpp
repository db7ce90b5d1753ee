// SPDX-License-Identifier: BSD-3-Clause
#include "plan_geometry.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

PlanLoop
loopOf(const std::vector<Eigen::Vector2d>& corners)
{
  PlanLoop loop;
  for (std::size_t k = 0; k < corners.size(); ++k)
    loop.elements.push_back(segment(corners[k], corners[(k + 1) % corners.size()]));
  return loop;
}

PlanLoop
loopAround(const Eigen::AlignedBox2d& box)
{
  const Eigen::Vector2d low = box.min();
  const Eigen::Vector2d high = box.max();
  return loopOf({low, {high.x(), low.y()}, high, {low.x(), high.y()}});
}

Eigen::AlignedBox2d
boxAround(const PlanElement& element)
{
  Eigen::AlignedBox2d box(element.start.cwiseMin(element.end),
                          element.start.cwiseMax(element.end));
  if (element.isArc()) {
    const Eigen::Vector2d radius = Eigen::Vector2d::Constant(element.radius);
    box.extend(element.centre - radius);
    box.extend(element.centre + radius);
  }
  return box;
}

Eigen::AlignedBox2d
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

std::optional<std::size_t>
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
