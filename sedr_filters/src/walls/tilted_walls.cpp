// SPDX-License-Identifier: BSD-3-Clause
#include "../plan/plan_geometry.h"

#include "plan_walls.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief Returns an element shifted to its left. */
PlanElement
shifted(PlanElement element, double shift)
{
  const Eigen::Vector2d at_end = element.normalAt(element.length());
  element.start += shift * element.normalAt(0);
  element.end += shift * at_end;
  if (element.isArc())
    element.radius += element.counter_clockwise ? -shift : shift;
  return element;
}

/** @brief Returns the intersection of two elements that met in `corner`, by Newton's
 * method because of arcs; where they are tangent, the middle between their ends. */
Eigen::Vector2d
meetingOf(const PlanElement& before, const PlanElement& after)
{
  constexpr int rounds = 20;
  constexpr double min_turn = 1e-3; // sine of the angle between them
  const Eigen::Vector2d between = (before.end + after.start) / 2;
  Eigen::Vector2d p = between;
  for (int round = 0; round < rounds; ++round) {
    Eigen::Matrix2d ways;
    Eigen::Vector2d way;
    Eigen::Vector2d off;
    off[0] = offLine(before, p, way);
    ways.row(0) = way;
    off[1] = offLine(after, p, way);
    ways.row(1) = way;
    if (std::abs(ways.determinant()) < min_turn)
      return between;
    const Eigen::Vector2d step = ways.inverse() * off;
    p -= step;
    if (step.norm() < 1e-12)
      break;
  }
  return p.allFinite() ? p : between;
}

/** @brief Returns the height of the floor at a wall, where its tilt starts. */
double
footOf(const PlanRoom& room, const PlanElement& wall)
{
  return room.floor.heightAt(wall.pointAt(wall.length() / 2));
}

} // namespace

bool
isTilted(const PlanRoom& room)
{
  return std::any_of(room.boundary.elements.begin(), room.boundary.elements.end(),
                     [](const PlanElement& wall) { return wall.tilt != 0; });
}

PlanRoom
withVerticalWalls(PlanRoom room)
{
  for (PlanElement& wall : room.boundary.elements)
    wall.tilt = 0;
  return room;
}

void
rejoin(PlanLoop& loop, const std::vector<bool>& is_moved)
{
  std::vector<PlanElement>& walls = loop.elements;
  const std::vector<PlanElement> old = walls;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    const std::size_t before = (i + walls.size() - 1) % walls.size();
    if (before == i || !(is_moved[before] || is_moved[i]))
      continue;
    const Eigen::Vector2d corner = meetingOf(old[before], old[i]);
    walls[before].end = corner;
    walls[i].start = corner;
  }
}

PlanElement
wallAt(const PlanRoom& room, std::size_t wall, double z)
{
  const std::vector<PlanElement>& walls = room.boundary.elements;
  const auto placed = [&](std::size_t i) {
    const PlanElement& foot = walls[i % walls.size()];
    const double run = std::tan(foot.tilt);
    return run != 0 ? shifted(foot, run * (z - footOf(room, foot))) : foot;
  };
  const PlanElement own = placed(wall);
  PlanElement cut = own;
  const PlanElement before = placed(wall + walls.size() - 1);
  const PlanElement after = placed(wall + 1);
  if (walls.size() > 1 && (own.tilt != 0 || before.tilt != 0))
    cut.start = meetingOf(before, own);
  if (walls.size() > 1 && (own.tilt != 0 || after.tilt != 0))
    cut.end = meetingOf(own, after);
  return cut;
}

PlanLoop
boundaryAt(const PlanRoom& room, double z)
{
  PlanLoop loop;
  for (std::size_t i = 0; i < room.boundary.elements.size(); ++i)
    loop.elements.push_back(wallAt(room, i, z));
  return loop;
}

double
headOf(const PlanRoom& room, std::size_t wall)
{
  constexpr int steps = 16;
  constexpr double inside = 0.01; // metres
  const PlanElement& e = room.boundary.elements[wall];
  const double foot = footOf(room, e);
  double head = -std::numeric_limits<double>::infinity();
  for (int k = 0; k <= steps; ++k) {
    const double s = e.length() * (k + 0.5) / (steps + 1);
    const auto ceilingOver = [&](double height) {
      const double out = std::tan(e.tilt) * (height - foot) + inside;
      return room.ceilingAt(e.pointAt(s) + out * e.normalAt(s));
    };
    head = std::max(head, ceilingOver(ceilingOver(foot)));
  }
  return head;
}

double
headOf(const PlanRoom& room)
{
  double head = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < room.boundary.elements.size(); ++i)
    if (room.boundary.elements[i].tilt != 0)
      head = std::max(head, headOf(room, i));
  return std::isfinite(head) ? head : room.ceiling.heightAt({0, 0});
}

PlanLoop
outermostBoundary(PlanRoom room)
{
  for (PlanElement& wall : room.boundary.elements)
    wall.tilt = std::min(wall.tilt, 0.0);
  return isTilted(room) ? boundaryAt(room, headOf(room)) : std::move(room.boundary);
}

double
tiltReach(const PlanRoom& room)
{
  if (!isTilted(room))
    return 0;
  double reach = 0;
  const double head = headOf(room);
  for (const PlanElement& wall : room.boundary.elements)
    reach =
        std::max(reach, std::abs(std::tan(wall.tilt) * (head - footOf(room, wall))));
  return reach;
}

} // namespace pcl::sedr
