// SPDX-License-Identifier: BSD-3-Clause
#include "../../plan_loops.h"
#include "says.h"
#include "sedr_surface/src/review/unlikely_places.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

std::vector<WarningKind>
kindsIn(const Floorplan& plan)
{
  std::vector<WarningKind> kinds;
  for (const PlanWarning& warning : unlikelyPlaces(plan)) {
    EXPECT_TRUE(warning.at.allFinite()) << sentenceOf(warning);
    EXPECT_FALSE(says(sentenceOf(warning), "?"));
    kinds.push_back(warning.kind);
  }
  return kinds;
}

/** A room of 4 m x 3 m with a door of a width. */
Floorplan
plainRoom(double width = 0.9)
{
  Floorplan plan;
  plan.rooms = {roomOf(rectangle(0, 0, 4, 3), 2.5)};
  plan.openings = {{OpeningKind::Door, {1, 0}, {}, {1, 0}, {1 + width, 0}, 0, 2}};
  return plan;
}

TEST(UnlikelyPlaces, NoneInAPlainRoom)
{
  EXPECT_TRUE(kindsIn(plainRoom()).empty());
}

TEST(UnlikelyPlaces, EachKindAlone)
{
  using Kinds = std::vector<WarningKind>;
  Floorplan plan = plainRoom();
  plan.openings[0].kind = OpeningKind::Window;
  EXPECT_EQ(kindsIn(plan), Kinds{WarningKind::NoDoor});
  EXPECT_EQ(kindsIn(plainRoom(0.6)), Kinds{WarningKind::NarrowDoor});
  plan = plainRoom();
  plan.rooms[0].boundary = rectangle(0, 0, 10, 0.7);
  EXPECT_EQ(kindsIn(plan), Kinds{WarningKind::NarrowRoom});
  plan.rooms[0].boundary = rectangle(0, 0, 1.5, 1.2);
  EXPECT_EQ(kindsIn(plan), (Kinds{WarningKind::SmallRoom, WarningKind::SmallStorey}));
  for (const double height : {1.9, 6.1}) {
    plan = plainRoom();
    plan.rooms[0] = roomOf(rectangle(0, 0, 4, 3), height);
    EXPECT_EQ(kindsIn(plan), Kinds{WarningKind::Height});
  }
  plan = plainRoom(); // a detail below the floor, beside the middle
  plan.rooms[0].details = {sedr_test::detailOf(rectangle(3.5, 0, 4, 3), -0.8)};
  EXPECT_EQ(kindsIn(plan), Kinds{WarningKind::Height});
  EXPECT_NEAR(unlikelyPlaces(plan)[0].values[0], -0.8, 1e-9);
  plan = plainRoom(); // an arc of 5 mm rise over 4 m
  PlanElement& arc = plan.rooms[0].boundary.elements[0];
  arc.radius = 400;
  arc.centre = {2, std::sqrt(400.0 * 400 - 4)};
  EXPECT_EQ(kindsIn(plan), Kinds{WarningKind::FlatArc});
  plan = plainRoom(); // cupboards of 2 m below a soffit of 4 m
  plan.rooms[0].boundary =
      sedr_test::polygon({{0, 0}, {4, 0}, {4, 2.5}, {2, 2.5}, {2, 3}, {0, 3}});
  plan.rooms[0].details = {sedr_test::detailOf(rectangle(0, 2.5, 2, 3), 2.1)};
  EXPECT_EQ(kindsIn(plan), Kinds{WarningKind::InLine});
  EXPECT_EQ(unlikelyPlaces(plan)[0].wall, 3u);
  EXPECT_NEAR(unlikelyPlaces(plan)[0].values[0], 2, 1e-9);
  plan = plainRoom();
  plan.rooms[0].floor_details = {sedr_test::detailOf(rectangle(0, 2, 4, 3), 0.4)};
  EXPECT_EQ(kindsIn(plan), Kinds{}) << "a stage from wall to wall";
  plan.rooms[0].floor_details = {sedr_test::detailOf(rectangle(2, 1, 4, 3), 0.4)};
  EXPECT_EQ(kindsIn(plan), Kinds{WarningKind::RaisedFloor});
}

} // namespace
