// SPDX-License-Identifier: BSD-3-Clause
#include "plan_frame.h"

#include <cmath>
#include <vector>

namespace pcl::sedr {
namespace {

/** @brief Returns the angle of a straight wall modulo a quarter turn: above -45
 * degrees, up to 45. */
double
quarterAngle(const PlanElement& e)
{
  const Eigen::Vector2d way = e.end - e.start;
  return std::remainder(std::atan2(way.y(), way.x()), M_PI / 2);
}

} // namespace

double
mainDirection(const Floorplan& plan)
{
  constexpr double along = 3 * M_PI / 180;
  constexpr double min_turn = 0.5 * M_PI / 180;
  constexpr std::size_t most_tried = 400; // walls: more have no other direction
  struct Wall {
    double angle;
    double length;
  };
  std::vector<Wall> walls;
  double whole = 0;
  for (const PlanRoom& room : plan.rooms)
    for (const PlanElement& e : room.boundary.elements) {
      whole += e.length();
      if (!e.isArc())
        walls.push_back({quarterAngle(e), e.length()});
    }
  double best = 0;
  double best_length = 0;
  for (std::size_t k = 0; k < walls.size(); k += walls.size() / most_tried + 1) {
    const double angle = walls[k].angle;
    double length = 0;
    double turn = 0;
    for (const Wall& wall : walls) {
      const double off = std::remainder(wall.angle - angle, M_PI / 2);
      if (std::abs(off) > along)
        continue;
      length += wall.length;
      turn += off * wall.length;
    }
    if (length <= best_length * (1 + 1e-9))
      continue;
    best_length = length;
    best = std::remainder(angle + turn / length, M_PI / 2);
  }
  const bool do_agree = best_length > 0.3 * whole;
  return do_agree && std::abs(best) > min_turn ? best : 0;
}

PlanElement
PlanFrame::operator()(PlanElement element) const
{
  for (Eigen::Vector2d* p : {&element.start, &element.end, &element.centre})
    *p = (*this)(*p);
  element.radius *= scale;
  return element;
}

PlanLoop
PlanFrame::operator()(PlanLoop loop) const
{
  for (PlanElement& e : loop.elements)
    e = (*this)(e);
  return loop;
}

Eigen::AlignedBox2d
boundsOf(const Floorplan& plan, const PlanFrame& frame)
{
  Eigen::AlignedBox2d box;
  for (const PlanRoom& room : plan.rooms) {
    box.extend(boundsOf(frame(room.boundary)));
    for (const PlanNiche& niche : room.niches)
      box.extend(boundsOf(frame(niche.boundary)));
    for (const PlanLoop& column : room.columns)
      box.extend(boundsOf(frame(column)));
  }
  return box;
}

} // namespace pcl::sedr
