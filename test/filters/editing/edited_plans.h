// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../../plan_loops.h"

#include <pcl/sedr_filters/floorplan_io.h>
#include <pcl/sedr_filters/plan_editor.h>

#include <gtest/gtest.h>

#include <string>

namespace sedr_test {

using namespace pcl::sedr;

/** Rooms of 4 m x 3 m and 2 m x 3 m with a wall of 20 cm and a door between them. */
inline Floorplan
twoRooms()
{
  Floorplan plan;
  plan.rooms = {roomOf(rectangle(0, 0, 4, 3), 2.5, 1),
                roomOf(rectangle(4.2, 0, 6.2, 3), 2.5, 2)};
  plan.openings = {
      {OpeningKind::Door, {1, 2}, {{1, 1}, {2, 3}}, {4.1, 1}, {4.1, 2}, 0, 2, 0, 0.2}};
  plan.storeys = {{1, "ground", 0, 2.5, {1, 2}}};
  return plan;
}

inline void
expectValid(const PlanEditor& editor)
{
  std::string problem;
  const Floorplan read =
      floorplanFromJson(floorplanToJson(editor.getFloorplan()), problem);
  EXPECT_EQ(problem, "");
  EXPECT_EQ(read.rooms.size(), editor.getFloorplan().rooms.size());
  for (const PlanRoom& room : editor.getFloorplan().rooms)
    EXPECT_EQ(outlineProblem(room.boundary), "");
}

} // namespace sedr_test
