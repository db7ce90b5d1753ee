// SPDX-License-Identifier: BSD-3-Clause
#include "wall_bodies.h"

#include "../walls/plan_walls.h"
#include "sedr_segmentation/src/curves/plan_segment.h"

#include <algorithm>

namespace pcl::sedr {
namespace {

/** @brief Returns the part of an element between two of its places, in its
 * direction. */
PlanElement
partBetween(const PlanElement& element,
            const Eigen::Vector2d& a,
            const Eigen::Vector2d& b)
{
  const auto [from, to] = std::minmax({element.project(a), element.project(b)});
  return element.part(from, to);
}

/** @brief Returns whether walls meet at a place: three of the four diagonals to a
 * wall's direction lead into rooms. At the outside of a building at most two do. */
bool
isJunction(const Floorplan& plan,
           const Eigen::Vector2d& place,
           const Eigen::Vector2d& way)
{
  constexpr double reach = 0.5; // metres
  const Eigen::Vector2d left(-way.y(), way.x());
  int rooms = 0;
  for (const Eigen::Vector2d& aslant :
       {Eigen::Vector2d(way + left), Eigen::Vector2d(way - left),
        Eigen::Vector2d(left - way), Eigen::Vector2d(-way - left)})
    if (std::any_of(plan.rooms.begin(), plan.rooms.end(), [&](const PlanRoom& room) {
          return room.boundary.contains(place + reach * aslant.normalized());
        }))
      ++rooms;
  return rooms >= 3;
}

/** @brief Extends a wall into a junction, to fill it.
 * @param near,far its faces, in opposite directions */
void
addEnd(const Floorplan& plan,
       const Eigen::Vector2d& near,
       const Eigen::Vector2d& far,
       const Eigen::Vector2d& way,
       PlanLoop& loop)
{
  const double thickness = (far - near).norm();
  if (!isJunction(plan, (near + far) / 2 + thickness / 2 * way, way)) {
    loop.elements.push_back(segment(near, far));
    return;
  }
  const Eigen::Vector2d on = thickness * way;
  loop.elements.push_back(segment(near, near + on));
  loop.elements.push_back(segment(near + on, far + on));
  loop.elements.push_back(segment(far + on, far));
}

} // namespace

std::vector<std::vector<PlanLoop>>
wallBodies(const Floorplan& plan, double max_wall)
{
  constexpr double min_length = 0.01;
  std::vector<std::vector<PlanLoop>> bodies;
  for (const PlanWall& wall : findWalls(plan, {max_wall})) {
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
    // The faces of a wall run in opposite directions, so both parts form a loop. At a
    // corner one face is longer by the thickness of the next wall.
    const PlanElement far =
        partBetween(other, element.pointAt(std::max(wall.stretch.from, 0.0)),
                    element.pointAt(std::min(wall.stretch.to, element.length())));
    const double from =
        std::max({element.project(far.end) - wall.thickness, 0.0, wall.stretch.from});
    const double to = std::min({element.project(far.start) + wall.thickness,
                                element.length(), wall.stretch.to});
    if (to - from < min_length || far.length() < min_length)
      continue;
    const PlanElement near = element.part(from, to);
    const Eigen::Vector2d way = (near.end - near.start).normalized();
    PlanLoop loop{{near}};
    addEnd(plan, near.end, far.start, way, loop);
    loop.elements.push_back(far);
    addEnd(plan, far.end, near.start, -way, loop);
    bodies.push_back({loop});
  }
  return bodies;
}

} // namespace pcl::sedr
