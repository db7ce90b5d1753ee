// SPDX-License-Identifier: BSD-3-Clause
#include "wall_bodies.h"

#include "../walls/plan_walls.h"

#include <algorithm>

namespace pcl {
namespace sedr {
namespace {

PlanElement
segmentBetween(const Eigen::Vector2d& from, const Eigen::Vector2d& to)
{
  PlanElement e;
  e.start = from;
  e.end = to;
  return e;
}

/** @brief The part of an element between two of its places, the way it runs. */
PlanElement
partBetween(const PlanElement& element, const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  const auto [from, to] = std::minmax({element.project(a), element.project(b)});
  return element.part(from, to);
}

} // namespace

std::vector<std::vector<PlanLoop>>
wallBodies(const Floorplan& plan)
{
  constexpr double least_length = 0.01;
  std::vector<std::vector<PlanLoop>> bodies;
  for (const PlanWall& wall : findWalls(plan)) {
    if (wall.isAssumed())
      continue;
    const PlanElement& element = elementOf(plan, wall.face);
    const PlanElement& other = elementOf(plan, *wall.other);
    const bool is_around = element.isArc() && other.isArc() &&
                           element.start == element.end && other.start == other.end;
    if (is_around) {
      bodies.push_back({{{element}}, {{other}}});
      continue;
    }
    // Faces of a wall run opposite ways, so that both parts make a loop; at a corner one
    // reaches beyond the other by the thickness of the next wall.
    const PlanElement far =
        partBetween(other, element.pointAt(std::max(wall.stretch.from, 0.0)),
                    element.pointAt(std::min(wall.stretch.to, element.length())));
    const double from = std::max({element.project(far.end) - wall.thickness, 0.0,
                                  wall.stretch.from});
    const double to = std::min({element.project(far.start) + wall.thickness,
                                element.length(), wall.stretch.to});
    if (to - from < least_length || far.length() < least_length)
      continue;
    const PlanElement near = element.part(from, to);
    bodies.push_back({{{near, segmentBetween(near.end, far.start), far,
                        segmentBetween(far.end, near.start)}}});
  }
  return bodies;
}

} // namespace sedr
} // namespace pcl
