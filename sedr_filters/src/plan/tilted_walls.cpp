// SPDX-License-Identifier: BSD-3-Clause
#include "plan_arcs.h"

#include <pcl/sedr_filters/straightening.h>

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

std::vector<double>
wallRuns(const PlanRoom& room)
{
  std::vector<double> runs;
  for (const PlanElement& wall : room.boundary.elements)
    runs.push_back(std::tan(wall.tilt));
  return runs;
}

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

PlanLoop
boundaryAt(const PlanRoom& room, double z)
{
  PlanLoop loop = room.boundary;
  const std::vector<double> runs = wallRuns(room);
  std::vector<bool> is_moved;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    PlanElement& wall = loop.elements[i];
    is_moved.push_back(runs[i] != 0);
    if (is_moved.back())
      wall = shifted(wall, runs[i] * (z - footOf(room, wall)));
  }
  rejoin(loop, is_moved);
  return loop;
}

double
headOf(const PlanRoom& room)
{
  constexpr int steps = 16;
  constexpr double inside = 0.01; // metres
  const std::vector<double> runs = wallRuns(room);
  double head = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const PlanElement& wall = room.boundary.elements[i];
    if (runs[i] == 0)
      continue;
    for (int k = 0; k <= steps; ++k) {
      const double s = wall.length() * (k + 0.5) / (steps + 1);
      const auto at = [&](double height) -> Eigen::Vector2d {
        const double out = runs[i] * (height - footOf(room, wall)) + inside;
        return wall.pointAt(s) + out * wall.normalAt(s);
      };
      const double guess = room.ceilingAt(at(footOf(room, wall)));
      head = std::max(head, room.ceilingAt(at(guess)));
    }
  }
  return std::isfinite(head) ? head : room.ceiling.heightAt({0, 0});
}

Floorplan
straightened(const Floorplan& plan)
{
  const Straightening map(tiltedFaces(plan));
  Floorplan straight = plan;
  for (PlanRoom& room : straight.rooms) {
    if (!isTilted(room))
      continue;
    const auto move = [&](PlanLoop& loop, const PlanSlab& slab) {
      for (PlanElement& element : loop.elements)
        for (Eigen::Vector2d* end : {&element.start, &element.end})
          if (!element.isArc()) {
            const Eigen::Vector3d p(end->x(), end->y(), slab.heightAt(*end));
            *end = map.straighten(p).head<2>();
          }
    };
    for (auto* const details : {&room.details, &room.floor_details})
      for (PlanDetail& detail : *details) {
        move(detail.boundary, detail.slab);
        for (PlanLoop& hole : detail.holes)
          move(hole, detail.slab);
      }
    room.boundary = boundaryAt(room, headOf(room));
    room = withVerticalWalls(std::move(room));
  }
  return straight;
}

std::vector<TiltedFace>
tiltedFaces(const Floorplan& plan)
{
  constexpr double beside = 0.1; // margin at floor and ceiling, metres
  std::vector<TiltedFace> faces;
  bool any = false;
  for (const PlanRoom& room : plan.rooms) {
    const std::vector<double> runs = wallRuns(room);
    const bool has_tilts = isTilted(room);
    any = any || has_tilts;
    const double head = has_tilts ? headOf(room) : room.ceiling.heightAt({0, 0});
    const PlanLoop top = has_tilts ? boundaryAt(room, head) : room.boundary;
    const auto& foot = room.boundary.elements;
    for (std::size_t i = 0; i < top.elements.size(); ++i) {
      const PlanElement& wall = top.elements[i];
      if (wall.isArc() || !(wall.length() > 0))
        continue;
      TiltedFace face;
      face.start = wall.start;
      face.end = wall.end;
      face.run = runs[i];
      const Eigen::Vector2d middle = wall.pointAt(wall.length() / 2);
      face.low = room.floor.heightAt(middle) - beside;
      face.head = has_tilts ? head : room.ceilingAt(middle) + beside;
      const Eigen::Vector2d way = (wall.end - wall.start).normalized();
      face.before_start += std::max(0.0, (wall.start - foot[i].start).dot(way));
      face.beyond_end += std::max(0.0, (foot[i].end - wall.end).dot(way));
      faces.push_back(face);
    }
  }
  return any ? faces : std::vector<TiltedFace>();
}

} // namespace pcl::sedr
