// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../../plan_loops.h"

#include <pcl/sedr_filters/floorplan.h>

#include <cstddef>

namespace pcl::sedr {

/** A room, 2.5 m high, of which all walls were measured, with a door. */
inline Floorplan
measuredRoom(const PlanLoop& outline = sedr_test::rectangle(0, 0, 4, 3))
{
  Floorplan plan;
  plan.rooms = {sedr_test::roomOf(outline, 2.5)};
  for (PlanElement& wall : plan.rooms[0].boundary.elements) {
    wall.evidence = {1, 0, 0};
    wall.accuracy = {0.002, 0.01};
  }
  PlanOpening door{OpeningKind::Door, {1, 0}, {{1, 0}}, {1, 0}, {2, 0}, 0, 2};
  door.confidence = 0.99;
  door.residual = 0.002;
  door.number = 1;
  plan.openings = {door};
  return plan;
}

/** Makes a wall of that room one of which a third was seen. */
inline void
hideWall(Floorplan& plan, std::size_t wall)
{
  PlanElement& element = plan.rooms[0].boundary.elements[wall - 1];
  element.evidence = {0.1, 0.6, 0.3};
  element.accuracy = {};
}

} // namespace pcl::sedr
