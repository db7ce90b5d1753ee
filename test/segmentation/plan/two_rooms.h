// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "room_evidence.h"

#include <cstdint>

namespace sedr_test {

/** Two rooms of different heights, with room numbers and a partition of 10 cm. */
struct TwoRooms {
  RoomPoints points{0.05, 0.003};
  PlanEvidence evidence;
  PlanLoop left = rectangle(0.01, 0.01, 4.01, 3.01);
  PlanLoop right = rectangle(4.11, 0.01, 7.11, 3.01);

  TwoRooms()
  {
    add(left, 2.5, 7);
    add(right, 2.8, 3);
    evidence.all = points.all();
  }

private:
  void add(const PlanLoop& loop, double height, std::uint32_t number)
  {
    const RoomParts parts = points.room(loop, 0, height);
    evidence.room.resize(points.size(), number);
    const PlanEvidence own = evidenceOf(points, parts);
    evidence.ceiling = joined(evidence.ceiling, own.ceiling);
    evidence.floor = joined(evidence.floor, own.floor);
    evidence.walls = joined(evidence.walls, own.walls);
  }
};

} // namespace sedr_test
