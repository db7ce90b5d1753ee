// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/priors.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

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
PlanLoop loopOf(const std::vector<Eigen::Vector2d>& corners);

/** @brief Returns the outline of a box. */
PlanLoop loopAround(const Eigen::AlignedBox2d& box);

/** @brief Returns a box around an element; for an arc, around its circle. */
Eigen::AlignedBox2d boxAround(const PlanElement& element);

/** @brief Returns the bounding box of a loop; empty without elements. Exact for arcs.
 * O(n). */
Eigen::AlignedBox2d boundsOf(const PlanLoop& loop);

/** @brief Planes of level ceilings are tilted by 3 degrees, those of roofs by more than
 * this; radians. */
constexpr double level_tilt = radians(4);

/** @brief Least upward component of the normal of a floor or ceiling: of a slope of 60
 * degrees, and two more that fits add. */
constexpr double min_upward = 0.469;

/** @brief Returns whether a slab is a level plane, not a slope or a curve. */
inline bool
isLevel(const PlanSlab& slab)
{
  return !slab.curve && slab.plane[2] >= std::cos(level_tilt);
}

/** @brief Returns whether a slab is a free form. */
inline bool
isRelief(const PlanSlab& slab)
{
  return slab.curve && slab.curve->kind == CurveKind::Relief;
}

constexpr double no_opening = 0.05; ///< width and height up to which it is none, metres

/** @brief Returns the element of a room's boundary that is nearest to an opening,
 * within 30 degrees and half a metre of its faces; nothing if there is none. */
std::optional<std::size_t> wallBeside(const PlanRoom& room, const PlanOpening& opening);

} // namespace pcl::sedr
