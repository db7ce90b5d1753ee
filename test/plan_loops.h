// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sedr_filters/src/plan/plan_geometry.h"

#include <Eigen/Geometry>

#include <cmath>
#include <vector>

namespace sedr_test {

using Corners = std::vector<Eigen::Vector2d>;

using pcl::sedr::segment;

/** Returns the arc about `centre` between two angles in degrees, counter-clockwise if
 * the second is larger. A difference of 360 is a whole circle with coinciding ends. */
inline pcl::sedr::PlanElement
arc(const Eigen::Vector2d& centre, double radius, double from, double to)
{
  const auto at = [&](double degrees) {
    const double a = degrees * M_PI / 180;
    return Eigen::Vector2d(centre + radius * Eigen::Vector2d(std::cos(a), std::sin(a)));
  };
  pcl::sedr::PlanElement e = segment(at(from), at(to));
  if (std::abs(to - from) == 360)
    e.end = e.start;
  e.centre = centre;
  e.radius = radius;
  e.counter_clockwise = to > from;
  return e;
}

inline pcl::sedr::PlanLoop
polygon(const Corners& corners)
{
  return pcl::sedr::loopOf(corners);
}

/** Counter-clockwise, from (x0, y0). */
inline pcl::sedr::PlanLoop
rectangle(double x0, double y0, double x1, double y1)
{
  return polygon({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}});
}

inline pcl::sedr::PlanLoop
circle(const Eigen::Vector2d& centre, double radius)
{
  return {{arc(centre, radius, 0, 360)}};
}

/** A rectangle from the origin with its corners rounded. */
inline pcl::sedr::PlanLoop
roundedRectangle(double width, double height, double r)
{
  return {{segment({r, 0}, {width - r, 0}), arc({width - r, r}, r, -90, 0),
           segment({width, r}, {width, height - r}),
           arc({width - r, height - r}, r, 0, 90),
           segment({width - r, height}, {r, height}), arc({r, height - r}, r, 90, 180),
           segment({0, height - r}, {0, r}), arc({r, r}, r, 180, 270)}};
}

/** A rectangle [0, length] x [-radius, radius] with a half circle at either end. */
inline pcl::sedr::PlanLoop
stadium(double length, double radius)
{
  return {{segment({0, -radius}, {length, -radius}), arc({length, 0}, radius, -90, 90),
           segment({length, radius}, {0, radius}), arc({0, 0}, radius, 90, 270)}};
}

/** Returns a rectangle from the origin with a half circle cut into its lower side: a
 * clockwise arc in a counter-clockwise loop. */
inline pcl::sedr::PlanLoop
bittenRectangle(double width, double height, double radius)
{
  const double middle = width / 2;
  return {{segment({0, 0}, {middle - radius, 0}), arc({middle, 0}, radius, 180, 0),
           segment({middle + radius, 0}, {width, 0}),
           segment({width, 0}, {width, height}), segment({width, height}, {0, height}),
           segment({0, height}, {0, 0})}};
}

/** Returns the loop turned about the origin by degrees, then shifted. */
inline pcl::sedr::PlanLoop
placed(pcl::sedr::PlanLoop loop, double degrees, const Eigen::Vector2d& shift)
{
  const Eigen::Rotation2Dd turn(degrees * M_PI / 180);
  for (auto& e : loop.elements)
    for (Eigen::Vector2d* p : {&e.start, &e.end, &e.centre})
      *p = turn * *p + shift;
  return loop;
}

/** The horizontal plane at a height, or one that rises by `slope_x`, `slope_y`. */
inline pcl::sedr::PlanSlab
slabAt(double height, double slope_x = 0, double slope_y = 0)
{
  pcl::sedr::PlanSlab slab;
  slab.plane = Eigen::Vector4d(-slope_x, -slope_y, 1, -height);
  slab.plane /= slab.plane.head<3>().norm();
  return slab;
}

inline pcl::sedr::PlanDetail
detailOf(const pcl::sedr::PlanLoop& boundary, double height)
{
  pcl::sedr::PlanDetail detail;
  detail.boundary = boundary;
  detail.slab = slabAt(height);
  return detail;
}

inline pcl::sedr::PlanRoom
roomOf(const pcl::sedr::PlanLoop& boundary, double height, std::uint32_t id = 1)
{
  pcl::sedr::PlanRoom room;
  room.id = id;
  room.boundary = boundary;
  room.floor = slabAt(0);
  room.ceiling = slabAt(height);
  return room;
}

} // namespace sedr_test
