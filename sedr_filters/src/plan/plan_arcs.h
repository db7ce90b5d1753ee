// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <algorithm>

namespace pcl::sedr {

inline double
cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

/** @brief Checks whether an arc is a whole circle. */
inline bool
isWhole(const PlanElement& arc)
{
  return (arc.start - arc.end).norm() <= 1e-9 * std::max(1.0, arc.radius);
}

/** @brief Returns an element's share of the winding number of its loop around `p`. */
inline int
windingOf(const PlanElement& e, const Eigen::Vector2d& p)
{
  // The winding of the chord, corrected for the circular segment beside it.
  int winding = 0;
  const double side = cross(e.end - e.start, p - e.start);
  const bool starts_below = e.start.y() <= p.y();
  const bool ends_below = e.end.y() <= p.y();
  if (starts_below && !ends_below && side > 0)
    ++winding;
  else if (!starts_below && ends_below && side < 0)
    --winding;
  if (!e.isArc() || (p - e.centre).norm() >= e.radius)
    return winding;
  // On the chord, the side on which the chord's own winding has put the point.
  const Eigen::Vector2d chord = e.end - e.start;
  const bool is_right =
      side < 0 || (side == 0 && (chord.y() > 0 || (chord.y() == 0 && chord.x() < 0)));
  if (isWhole(e) || is_right == e.counter_clockwise)
    winding += e.counter_clockwise ? 1 : -1;
  return winding;
}

/** @brief Returns the signed distance of a place from an element's line or circle,
 * positive to its left; `way` is the gradient. */
inline double
offLine(const PlanElement& element, const Eigen::Vector2d& p, Eigen::Vector2d& way)
{
  if (!element.isArc()) {
    way = element.normalAt(0);
    return (p - element.start).dot(way);
  }
  const double sign = element.counter_clockwise ? -1 : 1;
  const Eigen::Vector2d from = p - element.centre;
  way = sign * from.normalized();
  return sign * (from.norm() - element.radius);
}

} // namespace pcl::sedr
