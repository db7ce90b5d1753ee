// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../../plan_loops.h"

namespace sedr_test {

/** A room of 4 m x 3 m x 2.5 m of which all walls were measured, with a door. */
inline pcl::sedr::Floorplan
measuredRoom()
{
  pcl::sedr::Floorplan plan;
  plan.rooms = {roomOf(rectangle(0, 0, 4, 3), 2.5)};
  for (pcl::sedr::PlanElement& wall : plan.rooms[0].boundary.elements) {
    wall.evidence = {1, 0, 0};
    wall.accuracy = {0.002, 0.01};
  }
  pcl::sedr::PlanOpening door{
      pcl::sedr::OpeningKind::Door, {1, 0}, {{1, 0}}, {1, 0}, {2, 0}, 0, 2};
  door.confidence = 0.99;
  door.residual = 0.002;
  door.number = 1;
  plan.openings = {door};
  return plan;
}

} // namespace sedr_test
