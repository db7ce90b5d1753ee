// SPDX-License-Identifier: BSD-3-Clause
#include "../../plan_loops.h"

#include <pcl/sedr_filters/plan_editor.h>
#include <pcl/sedr_filters/plan_measures.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

using namespace pcl::sedr;
using sedr_test::rectangle;
using sedr_test::roomOf;
using sedr_test::slabAt;

namespace {

using Told = std::vector<std::string>;

/** Rooms of 4 m x 3 m and 2 m x 3 m with a wall of 20 cm and a door between them. */
Floorplan
roomsWithADoor()
{
  Floorplan plan;
  plan.rooms = {roomOf(rectangle(0, 0, 4, 3), 2.5, 1),
                roomOf(rectangle(4.2, 0, 6.2, 3), 2.5, 2)};
  plan.openings = {
      {OpeningKind::Door, {1, 2}, {{1, 1}, {2, 3}}, {4.1, 1}, {4.1, 2}, 0, 2, 0, 0.2}};
  numberOpenings(plan);
  return plan;
}

TEST(EditRefusals, OpeningsThatGoWithTheirWallsAreTold)
{
  PlanEditor merged(roomsWithADoor());
  ASSERT_TRUE(merged.merge(1, 2)) << merged.getErrorMessage();
  EXPECT_EQ(merged.getWarnings(), Told{"D1: the door at (4.10, 1.50) is in no wall any "
                                       "more: it is left out"});
  EXPECT_TRUE(merged.getFloorplan().openings.empty());
  Floorplan plan = roomsWithADoor();
  plan.openings[0].rooms[1] = 0;
  plan.openings[0].walls.pop_back();
  PlanEditor dropped(plan);
  ASSERT_TRUE(dropped.drop(1)) << dropped.getErrorMessage();
  EXPECT_EQ(dropped.getWarnings(), merged.getWarnings());
}

TEST(EditRefusals, WhatIsAddedHasTheHeightOfWhatIsBesideIt)
{
  Floorplan plan = roomsWithADoor();
  plan.rooms.pop_back();
  plan.openings.clear();
  PlanRoom& room = plan.rooms[0];
  room.ceiling = slabAt(9); // which is nowhere
  room.details = {{rectangle(0, 0, 1, 3), {}, slabAt(2.5), true},
                  {rectangle(1, 0, 4, 3), {}, slabAt(1, 0.5), true}};
  room.floor_details = {{rectangle(3, 0, 4, 3), {}, slabAt(0.2)}};
  PlanEditor editor(plan);
  ASSERT_TRUE(editor.moveWall(1, 3, 0.5)) << editor.getErrorMessage(); // y = 3
  ASSERT_TRUE(editor.moveWall(1, 2, 1)) << editor.getErrorMessage();   // x = 4
  const PlanRoom& now = editor.getFloorplan().rooms[0];
  for (const double x : {0.01, 0.3, 0.985, 1.015, 2.0, 3.9, 4.0, 4.1, 4.9})
    for (const double y : {0.01, 2.0, 2.9999, 3.0001, 3.3, 3.49}) {
      EXPECT_NEAR(now.ceilingAt({x, y}), x < 1 ? 2.5 : 1 + x / 2, 1e-9)
          << x << ' ' << y;
      EXPECT_NEAR(now.floorAt({x, y}), x > 3 ? 0.2 : 0, 1e-9) << x << ' ' << y;
    }
  EXPECT_TRUE(now.details.back().is_facet);
}

} // namespace
