// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "room_points.h"

#include <cstddef>
#include <cstdint>

namespace sedr_test {

/** A hole in a wall: range along it and height of the head. */
struct Hole {
  double from = 0;
  double to = 0;
  double head = 0;
};

/** Surfaces of a building with a point every 5 cm; its plan is turned about the origin.
 * Faces at 0.05 m, 0.15 m, ... are in the middle of profiles of 10 cm. */
class AirScene {
public:
  explicit AirScene(double degrees = 0)
      : degrees_(degrees)
  {}

  pcl::sedr::PlanLoop loop(double x0, double y0, double x1, double y1) const
  {
    return placed(rectangle(x0, y0, x1, y1), degrees_, {0, 0});
  }

  void slab(double x0, double y0, double x1, double y1, double z)
  {
    points.slab(loop(x0, y0, x1, y1), z);
  }

  /** Adds floor and ceiling. */
  void slabs(double x0, double y0, double x1, double y1, double low, double high)
  {
    slab(x0, y0, x1, y1, low);
    slab(x0, y0, x1, y1, high);
  }

  void wall(double x0, double y0, double x1, double y1, double low, double high)
  {
    points.wall(edge({x0, y0}, {x1, y1}), low, high);
  }

  /** Adds floor, ceiling and walls of a room without doors. */
  void room(double x0, double y0, double x1, double y1, double low, double high)
  {
    slabs(x0, y0, x1, y1, low, high);
    sides(x0, y0, x1, y1, low, high);
  }

  /** Adds the four vertical faces of a box. */
  void sides(double x0, double y0, double x1, double y1, double low, double high)
  {
    for (const auto& e : loop(x0, y0, x1, y1).elements)
      points.wall(e, low, high);
  }

  /** Adds the visible faces of a box that hangs from above: underside and sides. */
  void hanging(double x0, double y0, double x1, double y1, double low, double high)
  {
    slab(x0, y0, x1, y1, low);
    sides(x0, y0, x1, y1, low, high);
  }

  /** Adds both faces of a wall of 10 cm along y, at x and x + 0.1, with the reveal of a
   * hole: its jambs, threshold and head. */
  void partition(double x, double y0, double y1, double low, double high, Hole hole)
  {
    const auto isWall = [&](double s, double z) {
      return y0 + s < hole.from || y0 + s > hole.to || z > hole.head;
    };
    for (const double face : {x, x + 0.1})
      points.wall(edge({face, y0}, {face, y1}), low, high, isWall);
    for (const double side : {hole.from, hole.to})
      wall(x, side, x + 0.1, side, low, hole.head);
    slab(x, hole.from, x + 0.1, hole.to, low);
    slab(x, hole.from, x + 0.1, hole.to, hole.head);
  }

  /** Returns a place of the scene after the turn. */
  Eigen::Vector2d place(double x, double y) const
  {
    return Eigen::Rotation2Dd(degrees_ * M_PI / 180) * Eigen::Vector2d(x, y);
  }

  RoomPoints points{0.05};

private:
  pcl::sedr::PlanElement edge(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const
  {
    return segment(place(a.x(), a.y()), place(b.x(), b.y()));
  }

  double degrees_;
};

/** Adds rooms of 4 m x 3 m and 3 m x 3 m, 10 cm of wall and a hole between them. */
inline void
addTwoRooms(AirScene& scene, Hole hole)
{
  for (const auto& [x0, x1] : {std::pair(0.05, 4.05), std::pair(4.15, 7.15)}) {
    scene.slabs(x0, 0.05, x1, 3.05, 0.01, 2.51);
    for (const double y : {0.05, 3.05})
      scene.wall(x0, y, x1, y, 0.01, 2.51);
  }
  for (const double x : {0.05, 7.15})
    scene.wall(x, 0.05, x, 3.05, 0.01, 2.51);
  scene.partition(4.05, 0.05, 3.05, 0.01, 2.51, hole);
}

} // namespace sedr_test
