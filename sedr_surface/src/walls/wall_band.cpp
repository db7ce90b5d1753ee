// SPDX-License-Identifier: BSD-3-Clause
#include "wall_band.h"

#include "sedr_filters/src/plan/plan_bounds.h"
#include "sedr_filters/src/plan/plan_segment.h"

#include <pcl/sedr_filters/plan_measures.h>

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

bool
isExternal(const Floorplan& plan, const PlanWall& wall)
{
  constexpr double reach = 3; // metres
  constexpr double step = 0.1;
  constexpr int places = 3;
  if (wall.other)
    return false;
  const PlanRoom& own = plan.rooms[wall.face.room];
  const auto isOfWall = [&](const OpeningWall& w) {
    return wall.face.loop == 0 && w.room == own.id && w.element == wall.face.element;
  };
  if (std::any_of(plan.openings.begin(), plan.openings.end(),
                  [&](const PlanOpening& o) {
                    return o.kind == OpeningKind::Window && o.leadsOutside() &&
                           std::any_of(o.walls.begin(), o.walls.end(), isOfWall);
                  }))
    return true;
  int free = 0;
  for (int k = 0; k < places; ++k) {
    const auto [place, inward] =
        faceAt(elementOf(plan, wall.face),
               wall.stretch.from + wall.stretch.length() * (k + 0.5) / places);
    Eigen::AlignedBox2d way(place);
    way.extend(place - reach * inward);
    free += std::none_of(plan.rooms.begin(), plan.rooms.end(),
                         [&, at = place, in = inward](const PlanRoom& room) {
                           if (!way.intersects(boundsOf(room.boundary)) ||
                               !shareHeights(room, own))
                             return false;
                           for (double off = wall.thickness; off < reach; off += step)
                             if (room.contains(at - off * in))
                               return true;
                           return false;
                         })
                ? 1
                : 0;
  }
  return free > places / 2;
}

} // namespace pcl::sedr
