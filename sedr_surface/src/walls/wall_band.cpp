// SPDX-License-Identifier: BSD-3-Clause
#include "wall_band.h"

#include "sedr_filters/src/plan/plan_segment.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {
namespace {

/** @brief Returns the part of a curved wall's face that belongs to the wall. */
PlanElement
nearSideOf(const PlanElement& element, const Stretch& stretch)
{
  const bool is_whole = stretch.from <= 0 && stretch.to >= element.length();
  return is_whole ? element
                  : element.part(std::max(stretch.from, 0.0),
                                 std::min(stretch.to, element.length()));
}

/** @brief Returns the arc with the same centre and another radius. */
PlanElement
withRadius(PlanElement arc, double radius)
{
  for (Eigen::Vector2d* p : {&arc.start, &arc.end})
    *p = arc.centre + (*p - arc.centre) * (radius / arc.radius);
  arc.radius = radius;
  return arc;
}

PlanLoop
counterClockwise(const PlanLoop& loop)
{
  return loop.area() < 0 ? reversed(loop) : loop;
}

} // namespace

PlanElement
farSideOf(const Floorplan& plan, const PlanWall& wall)
{
  const PlanElement& element = elementOf(plan, wall.face);
  if (!element.isArc()) {
    const WallFrame frame = frameOf(plan, wall);
    return segment(frame.toPlan(wall.outline[3]), frame.toPlan(wall.outline[2]));
  }
  constexpr double min_radius = 0.01;
  return withRadius(nearSideOf(element, wall.stretch),
                    element.counter_clockwise
                        ? element.radius + wall.thickness
                        : std::max(element.radius - wall.thickness, min_radius));
}

PlanArea
bandOf(const Floorplan& plan, const PlanWall& wall)
{
  const PlanElement& element = elementOf(plan, wall.face);
  const PlanElement far = farSideOf(plan, wall);
  if (!element.isArc()) {
    const WallFrame frame = frameOf(plan, wall);
    return {loopOf({frame.toPlan(wall.outline[0]), far.start, far.end,
                    frame.toPlan(wall.outline[1])})};
  }
  const PlanElement near = nearSideOf(element, wall.stretch);
  if (std::abs(near.sweep()) > 2 * M_PI - 1e-6) {
    const bool is_outside = far.radius > near.radius;
    return {counterClockwise({{is_outside ? far : near}}),
            {counterClockwise({{is_outside ? near : far}})}};
  }
  return {counterClockwise(
      {{near, segment(near.end, far.end), reversed({{far}}).elements.front(),
        segment(far.start, near.start)}})};
}

} // namespace pcl::sedr
