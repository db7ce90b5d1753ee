// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "room_points.h"

#include <Eigen/Core>

namespace sedr_test {

/** Returns the points of a room, 5 cm apart, turned about the origin and shifted by 30
 * m. */
inline RoomPoints
turned(const pcl::sedr::PlanRoom& plan, const Eigen::Matrix3d& turn, double noise)
{
  RoomPoints room(0.05, noise);
  room.room(plan);
  RoomPoints result;
  for (const int i : room.all()) {
    const Eigen::Vector3d p =
        turn * room[i].cast<double>().eval() + Eigen::Vector3d(30, -20, 5);
    result.point(p.x(), p.y(), p.z());
  }
  return result;
}

} // namespace sedr_test
