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

} // namespace
