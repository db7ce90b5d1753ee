// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "room_evidence.h"

namespace sedr_test {

/** Two rooms of different heights, with room numbers and a partition of 10 cm. */
struct UnequalRooms {
  RoomPoints points{0.05, 0.003};
  PlanEvidence evidence;
  PlanLoop left = rectangle(0.01, 0.01, 4.01, 3.01);
  PlanLoop right = rectangle(4.11, 0.01, 7.11, 3.01);

  UnequalRooms()
  {
    addRoom(points, points.room(left, 0, 2.5), 7, evidence);
    addRoom(points, points.room(right, 0, 2.8), 3, evidence);
  }
};

} // namespace sedr_test
