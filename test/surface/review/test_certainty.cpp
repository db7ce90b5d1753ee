// SPDX-License-Identifier: BSD-3-Clause
#include "../../plan_loops.h"
#include "measured_room.h"

#include <gtest/gtest.h>
#include <pcl/sedr_surface/plan_review.h>

#include <string>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

TEST(Certainty, SignsAreWhatTheScanShowsOfAWall)
{
  Floorplan plan = measuredRoom();
  PlanElement& wall = plan.rooms[0].boundary.elements[2];
  wall.evidence = {0.5, 0.3, 0.2};
  wall.accuracy.standard_error = 0.006; // three times that of the others
  const auto walls = certaintyOfWalls(plan, {{WarningKind::WallOff, {2, -7}, 1, 3},
                                             {WarningKind::WallOff, {1, 9}, 1, 3},
                                             {WarningKind::InLine, {2}, 1, 3},
                                             {WarningKind::WallOff, {1, 9}, 1, 0}});
  ASSERT_EQ(walls.size(), 4u);
  EXPECT_EQ(walls[2].element, "1.3");
  EXPECT_NEAR(walls[2].area, 10, 1e-9);
  const std::vector<double> truth{std::log(4), 0.5, 1, std::log(3), 0, 0.3, 0, 1};
  ASSERT_EQ(walls[2].signs.size(), truth.size());
  EXPECT_EQ(wallSigns().size(), truth.size());
  for (std::size_t k = 0; k < truth.size(); ++k)
    EXPECT_NEAR(walls[2].signs[k], truth[k], 1e-9) << wallSigns()[k];
  EXPECT_EQ(walls[1].signs.back(), 0);
}

TEST(Certainty, OfAWallBehindWhichItsCeilingGoesOnIsLittle)
{
  const auto of = [](std::vector<double> values) {
    return certaintyOfWalls(measuredRoom(), {{WarningKind::WallOff, values, 1, 3}})[2];
  };
  EXPECT_GT(of({10, -38}).right(), 0.5) << "as much is seen behind it";
  EXPECT_LT(of({10, -38, 4}).right(), 0.5);
  EXPECT_NEAR(*(of({2.5, -38, 1}).signs.rbegin() + 1), 0.25, 1e-9) << "of its length";
  Floorplan plan = measuredRoom(); // a window of 3 x 2.5 m in the wall of 4 m
  plan.rooms[0].boundary.elements[2].evidence = {0.25, 0, 0.75};
  PlanOpening& window = plan.openings[0];
  window.walls = {{1, 2}};
  window.start = {3.5, 3};
  window.end = {0.5, 3};
  window.bottom = 0;
  window.top = 2.5;
  EXPECT_NEAR(*(certaintyOfWalls(plan, {{WarningKind::WallOff, {10, -38, 4}, 1, 3}})[2]
                    .signs.rbegin() +
                1),
              0.25, 1e-9)
      << "of what is no opening";
}

TEST(Certainty, FallsWithEachThingThatSpeaksAgainstAWall)
{
  const auto of = [](const Floorplan& plan, double off) {
    return certaintyOfWalls(plan, {{WarningKind::WallOff, {off, 7}, 1, 3}})[2].right();
  };
  const double best = of(measuredRoom(), 0);
  EXPECT_GT(best, 0.95);
  EXPECT_LT(of(measuredRoom(), 5), best);
  EXPECT_LT(
      certaintyOfWalls(measuredRoom(), {{WarningKind::InLine, {4}, 1, 3}})[2].right(),
      best);
  Floorplan plan = measuredRoom();
  PlanElement& wall = plan.rooms[0].boundary.elements[2];
  wall.accuracy.standard_error = 0.03;
  EXPECT_LT(of(plan, 0), best);
  wall.accuracy = {};
  wall.evidence = {0, 0.5, 0.5};
  EXPECT_LT(of(plan, 0), 0.9);
  plan.rooms[0].boundary = sedr_test::rectangle(0, 0, 0.1, 3);
  for (PlanElement& any : plan.rooms[0].boundary.elements)
    any.evidence = {0, 0.5, 0.5};
  EXPECT_LT(of(plan, 0), 0.3) << "short ones follow their neighbours";
}

TEST(Certainty, OfOpeningsFollowsTheirEdges)
{
  Floorplan plan = measuredRoom();
  plan.openings.resize(3, plan.openings[0]);
  plan.openings[0].residual = 0.02; // ten times that of the others
  plan.openings[2].confidence = 0.9;
  plan.openings[2].number = 3;
  const auto doors = certaintyOfOpenings(plan);
  const Certainty& door = doors[2];
  EXPECT_EQ(door.element, "D3");
  EXPECT_NEAR(door.area, 2, 1e-9);
  EXPECT_NEAR(door.signs[0], std::log(9), 1e-9);
  EXPECT_EQ(door.signs[1], 0);
  EXPECT_NEAR(doors[0].signs[1], std::log(10), 1e-9);
  EXPECT_EQ(door.signs.size(), openingSigns().size());
  EXPECT_GT(door.right(), 0.8);
  EXPECT_LT(doors[0].right(), 0.6);
  plan.openings[2].edges = {{{EdgeSeen::Nothing, 0.07}, {EdgeSeen::Rim, 0.01}}};
  EXPECT_LT(certaintyOfOpenings(plan)[2].right(), door.right() - 0.1);
}

TEST(Certainty, NothingIsSaidOfWhatIsNotKnown)
{
  Floorplan plan = measuredRoom();
  EXPECT_TRUE(certaintyOfWalls({{roomOf(rectangle(0, 0, 4, 3), 2.5)}}, {}).empty());
  PlanElement& wall = plan.rooms[0].boundary.elements[0];
  wall.evidence = {0, 0, 1}; // a door from end to end
  plan.openings[0].start = wall.start;
  plan.openings[0].end = wall.end;
  plan.openings[0].top = 2.5;
  plan.openings.resize(3, plan.openings[0]);
  plan.openings[0].confidence = 0;
  plan.openings[1].confidence = 1; // as PlanEditor sets openings by hand
  plan.openings[1].residual = 0;
  EXPECT_EQ(certaintyOfWalls(plan, {{WarningKind::WallOff, {}, 1, 2}}).size(), 3u);
  const auto openings = certaintyOfOpenings(plan);
  ASSERT_EQ(openings.size(), 1u);
  EXPECT_EQ(openings[0].index, 2u);
}

} // namespace
