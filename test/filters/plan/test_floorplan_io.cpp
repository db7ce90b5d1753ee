// SPDX-License-Identifier: BSD-3-Clause
#include "plan_loops.h"

#include <pcl/sedr_filters/floorplan_io.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** A plan with all kinds of parts, whose numbers have no short decimal form. */
Floorplan
samplePlan()
{
  Floorplan plan;
  PlanRoom room = roomOf(placed(bittenRectangle(6, 4, 1), 10, {1e4 / 3, -0.1}), 2.5, 3);
  room.boundary.elements[0].inliers = 123456789;
  room.boundary.elements[0].residual = 1.0 / 3;
  room.boundary.elements[0].evidence = {1.0 / 7, 0.5, 5.0 / 14};
  room.floor.plane = Eigen::Vector4d(1e-300, -1.0 / 7, std::sqrt(1 - 1.0 / 49), -0.1);
  room.floor.inliers = 17;
  room.floor.residual = 0.1 + 0.2;
  room.columns = {reversed(circle({M_PI, M_E}, 0.2)), reversed(rectangle(1, 1, 2, 2))};
  room.details = {detailOf(stadium(2, 0.3), 2.2), detailOf(rectangle(0, 0, 1, 1), 2.7)};
  room.details[0].holes = {reversed(circle({1, 0}, 0.1)),
                           reversed(rectangle(0, 0, 0.1, 0.1))};
  room.floor_details = {detailOf(rectangle(1, 1, 2, 1 + M_E), 0.1 / 3)};
  room.niches = {{stadium(1, 0.1 / 3), slabAt(0.1), slabAt(2.0 / 3)}};
  plan.rooms.push_back(room);
  plan.rooms.push_back(
      roomOf(rectangle(-1.0 / 3, 5e-324, 0.1, 1.0 / 7), 3, 4294967295u));
  return plan;
}

std::string
problemOf(const std::string& text)
{
  std::string problem = "none yet";
  EXPECT_TRUE(floorplanFromJson(text, problem).rooms.empty()) << text;
  return problem;
}

TEST(FloorplanJson, ReadsBackExactly)
{
  const Floorplan plan = samplePlan();
  std::string problem = "none yet";
  const Floorplan read = floorplanFromJson(floorplanToJson(plan), problem);
  EXPECT_EQ(problem, "");
  ASSERT_EQ(read.rooms.size(), 2u);
  const PlanRoom& room = read.rooms[0];
  const PlanElement& wall = room.boundary.elements[0];
  EXPECT_EQ(wall.inliers, 123456789u);
  EXPECT_EQ(wall.residual, 1.0 / 3);
  EXPECT_EQ(wall.evidence.hidden, 0.5);
  EXPECT_EQ(room.floor.plane, plan.rooms[0].floor.plane);
  EXPECT_EQ(room.columns[0].elements[0].centre, Eigen::Vector2d(M_PI, M_E));
  EXPECT_EQ(room.details[0].holes.size(), 2u);
  EXPECT_EQ(room.floor_details[0].slab.plane,
            plan.rooms[0].floor_details[0].slab.plane);
  EXPECT_EQ(room.niches[0].top.plane, plan.rooms[0].niches[0].top.plane);
  EXPECT_EQ(floorplanToJson(read), floorplanToJson(plan));
}

TEST(FloorplanJson, TheOriginReadsBackAndMayBeMissing)
{
  const Origin origin{{691600.1, 5335900 + 1.0 / 3, -12}};
  Origin read;
  ASSERT_TRUE(originFromJson(floorplanToJson(samplePlan(), nullptr, origin), read));
  EXPECT_EQ(read, origin);
  EXPECT_TRUE(originFromJson(floorplanToJson(samplePlan()), read));
  EXPECT_TRUE(read.isZero());
  EXPECT_TRUE(originFromJson("{\"rooms\": []}", read));
  EXPECT_TRUE(read.isZero());
  EXPECT_FALSE(originFromJson("{\"origin\": [1, 2]}", read));
  EXPECT_FALSE(originFromJson("{\"origin\": [1, 2, \"3\"]}", read));
}

TEST(FloorplanJson, StatesTheMaximumThicknessOfAWall)
{
  const auto read = [](const std::string& text) {
    std::string problem;
    const double max_wall = maxWallFromJson(text, problem);
    return problem.empty() ? std::to_string(max_wall) : problem;
  };
  const std::string usual = std::to_string(Priors().max_wall);
  EXPECT_EQ(read(floorplanToJson(samplePlan())), usual);
  const std::string castle = floorplanToJson(samplePlan(), nullptr, {}, 1.5);
  EXPECT_EQ(read(castle), std::to_string(1.5));
  EXPECT_EQ(
      read(R"({"max_wall": 1e9})").find("the prior max_wall must be from 0.1 to 3"),
      0u);
  EXPECT_EQ(read(R"({"max_wall": "wide"})"),
            "the max_wall must be a number, it is \"wide\"");
  EXPECT_EQ(read("{"), usual);
}

TEST(FloorplanJson, TruncatedTextIsRefusedWhereverItEnds)
{
  const std::string text = floorplanToJson(samplePlan());
  for (std::size_t n = 0; n + 2 < text.size(); n += 7)
    ASSERT_NE(problemOf(text.substr(0, n)), "") << n << " of " << text.size();
}

} // namespace
