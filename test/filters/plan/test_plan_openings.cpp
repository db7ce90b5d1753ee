// SPDX-License-Identifier: BSD-3-Clause
#include "plan_loops.h"

#include <pcl/sedr_filters/floorplan_io.h>
#include <pcl/sedr_filters/plan_measures.h>

#include <gtest/gtest.h>

#include <string>

namespace pcl::sedr {
namespace {

Floorplan
planWithADoor()
{
  Floorplan plan;
  plan.rooms = {sedr_test::roomOf(sedr_test::rectangle(0, 0, 4, 3), 2.5, 3)};
  PlanOpening door;
  door.kind = OpeningKind::Door;
  door.rooms = {3, 0};
  door.walls = {{3, 0}};
  door.start = Eigen::Vector2d(1, -0.1);
  door.end = Eigen::Vector2d(1.9, -0.1);
  door.top = 2.05;
  door.rise = 0.2;
  door.depth = 0.2;
  door.hinge = OpeningHinge::End;
  door.swing = 3;
  door.state = OpeningState::Ajar;
  door.confidence = 0.9;
  door.residual = 0.003;
  plan.openings = {door};
  return plan;
}

TEST(PlanOpenings, ReadBackAsWritten)
{
  std::string problem;
  const Floorplan read = floorplanFromJson(floorplanToJson(planWithADoor()), problem);
  ASSERT_EQ(problem, "");
  ASSERT_EQ(read.openings.size(), 1u);
  const PlanOpening& door = read.openings[0];
  EXPECT_EQ(door.kind, OpeningKind::Door);
  EXPECT_EQ(door.rooms[0], 3u);
  ASSERT_EQ(door.walls.size(), 1u);
  EXPECT_EQ(door.walls[0].room, 3u);
  EXPECT_EQ(door.start, Eigen::Vector2d(1, -0.1));
  EXPECT_EQ(door.top, 2.05);
  EXPECT_EQ(door.rise, 0.2);
  EXPECT_EQ(door.hinge, OpeningHinge::End);
  EXPECT_EQ(door.swing, 3u);
  EXPECT_EQ(door.state, OpeningState::Ajar);
  EXPECT_EQ(door.confidence, 0.9);
}

TEST(PlanOpenings, LeavesHangAtTheFaceOfTheirSide)
{
  PlanOpening door = planWithADoor().openings[0];
  ASSERT_EQ(leavesOf(door).size(), 1u);
  EXPECT_TRUE(leavesOf(door)[0].hinge.isApprox(Eigen::Vector2d(1.9, 0)));
  EXPECT_TRUE(leavesOf(door)[0].shut.isApprox(Eigen::Vector2d(1, 0)));
  EXPECT_TRUE(leavesOf(door)[0].open.isApprox(Eigen::Vector2d(1.9, 0.9)));
  door.hinge = OpeningHinge::Both;
  door.swing = 0; // the outside, to the right
  ASSERT_EQ(leavesOf(door).size(), 2u);
  EXPECT_TRUE(leavesOf(door)[0].hinge.isApprox(Eigen::Vector2d(1, -0.2)));
  EXPECT_TRUE(leavesOf(door)[0].shut.isApprox(Eigen::Vector2d(1.45, -0.2)));
  EXPECT_TRUE(leavesOf(door)[1].open.isApprox(Eigen::Vector2d(1.9, -0.65)));
  door.hinge = OpeningHinge::Unknown;
  EXPECT_TRUE(leavesOf(door).empty());
}

TEST(PlanOpenings, InvalidOnesAreRefused)
{
  const auto problemWith = [](const auto& spoil) {
    Floorplan plan = planWithADoor();
    spoil(plan.openings[0]);
    std::string problem;
    floorplanFromJson(floorplanToJson(plan), problem);
    return problem;
  };
  EXPECT_NE(problemWith([](PlanOpening& o) { o.rooms[1] = 9; }).find("room 9"),
            std::string::npos);
  EXPECT_NE(problemWith([](PlanOpening& o) { o.walls[0].element = 4; }).find("wall 4"),
            std::string::npos);
  EXPECT_NE(problemWith([](PlanOpening& o) { o.end = o.start; }).find("width"),
            std::string::npos);
  EXPECT_NE(problemWith([](PlanOpening& o) { o.top = -1; }).find("top"),
            std::string::npos);
  EXPECT_NE(problemWith([](PlanOpening& o) { o.rise = 3; }).find("rise"),
            std::string::npos);
  EXPECT_NE(problemWith([](PlanOpening& o) { o.confidence = 2; }).find("confidence"),
            std::string::npos);
}

TEST(PlanOpenings, AnUnknownNameIsRefused)
{
  std::string text = floorplanToJson(planWithADoor());
  text.replace(text.find("\"ajar\""), 6, "\"shut\"");
  std::string problem;
  floorplanFromJson(text, problem);
  EXPECT_NE(problem.find("state"), std::string::npos);
}

TEST(PlanOpenings, ADoorwayThatIsAnOpeningIsNoOther)
{
  Floorplan plan = planWithADoor();
  plan.doorways = {{{3, 0}, {1.1, 0}, {1.8, 0}, 0, 2},
                   {{3, 0}, {3, 0}, {3.8, 0}, 0, 2}};
  const auto others = otherDoorways(plan);
  ASSERT_EQ(others.size(), 1u);
  EXPECT_EQ(others[0].start.x(), 3);
}

} // namespace
} // namespace pcl::sedr
