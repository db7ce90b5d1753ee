// SPDX-License-Identifier: BSD-3-Clause
#include "plan_loops.h"

#include <pcl/sedr_filters/floorplan_io.h>

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** A room with a round corner, a column and a detail. */
Floorplan
smallPlan()
{
  Floorplan plan;
  plan.rooms.push_back(roomOf(roundedRectangle(6, 4, 1), 2.5, 7));
  plan.rooms[0].columns = {reversed(circle({3, 2}, 0.3))};
  plan.rooms[0].details = {detailOf(rectangle(1, 1, 2, 2), 2.2)};
  return plan;
}

std::string
problemOf(const Floorplan& plan)
{
  std::string problem;
  const Floorplan read = floorplanFromJson(floorplanToJson(plan), problem);
  EXPECT_EQ(read.rooms.empty(), !problem.empty());
  return problem;
}

void
expectRefused(const Floorplan& plan, const std::string& word)
{
  const std::string problem = problemOf(plan);
  EXPECT_NE(problem.find(word), std::string::npos) << "'" << problem << "'";
}

TEST(FloorplanLimits, APlanWithinThemIsRead)
{
  EXPECT_EQ(problemOf(smallPlan()), "");
}

TEST(FloorplanLimits, CoordinatesBeyondAThousandKilometresAreRefused)
{
  Floorplan plan;
  plan.rooms.push_back(roomOf(rectangle(999990, -1e6, 1e6, -999990), 2.5));
  EXPECT_EQ(problemOf(plan), "");
  plan.rooms[0].boundary = rectangle(0, 0, 1.5e6, 1);
  expectRefused(plan, "1.5e+06");
  plan = smallPlan();
  plan.rooms[0].floor.plane[3] = -1e7;
  expectRefused(plan, "-1e+07");
}

TEST(FloorplanLimits, SlabsTiltedTooMuchAreRefused)
{
  Floorplan plan = smallPlan();
  plan.rooms[0].ceiling = slabAt(2.5, 1.73); // 60 degrees
  EXPECT_EQ(problemOf(plan), "");
  plan.rooms[0].ceiling = slabAt(2.5, 1.82); // 61.2 degrees, as a fit may have
  EXPECT_EQ(problemOf(plan), "");
  plan.rooms[0].ceiling = slabAt(2.5, 1.9);
  expectRefused(plan, "face up");
  plan = smallPlan();
  plan.rooms[0].details[0].slab = slabAt(2.2, 0, -2);
  expectRefused(plan, "face up");
}

TEST(FloorplanLimits, NormalsAreBroughtToUnitLengthOrRefused)
{
  Floorplan plan = smallPlan();
  plan.rooms[0].ceiling.plane = Eigen::Vector4d(0, 0, 1.0005, -2.5 * 1.0005);
  std::string problem;
  const Floorplan read = floorplanFromJson(floorplanToJson(plan), problem);
  ASSERT_EQ(problem, "");
  EXPECT_NEAR((read.rooms[0].ceiling.plane - Eigen::Vector4d(0, 0, 1, -2.5)).norm(), 0,
              1e-12);
  plan.rooms[0].ceiling.plane = Eigen::Vector4d(0, 0, 1.002, -2.5);
  expectRefused(plan, "1.002");
  plan.rooms[0].ceiling.plane = Eigen::Vector4d(0, 0, 0, -2.5);
  expectRefused(plan, "length 1");
}

TEST(FloorplanLimits, EndsOfArcsMustLieOnTheirCircle)
{
  Floorplan plan = smallPlan();
  plan.rooms[0].boundary.elements[1].radius += 0.0009;
  EXPECT_EQ(problemOf(plan), "");
  plan.rooms[0].boundary.elements[1].radius += 0.0002;
  expectRefused(plan, "0.0011");
}

TEST(FloorplanLimits, ArcsOfAHugeRadiusAreRefused)
{
  Floorplan plan = smallPlan();
  plan.rooms[0].columns = {reversed(circle({0, 0}, 1.1e5))};
  expectRefused(plan, "110000");
}

TEST(FloorplanLimits, IdsOfRoomsAreWholeNumbersFromOneEachOnce)
{
  Floorplan plan = smallPlan();
  plan.rooms.push_back(roomOf(rectangle(10, 0, 12, 2), 2.5, 8));
  EXPECT_EQ(problemOf(plan), "");
  plan.rooms[1].id = 7;
  expectRefused(plan, "two rooms have the id 7");
  plan.rooms[1].id = 0;
  expectRefused(plan, "not 0");
  for (const char* bad : {"-1", "4294967296", "7.5", "\"7\""}) {
    std::string text = floorplanToJson(smallPlan());
    text.replace(text.find("\"id\": 7") + 6, 1, bad);
    std::string problem;
    floorplanFromJson(text, problem);
    EXPECT_NE(problem.find(std::string("not ") + bad), std::string::npos) << problem;
  }
}

TEST(FloorplanLimits, BoundariesMustRunAroundSomeAreaCounterClockwise)
{
  Floorplan plan = smallPlan();
  plan.rooms[0].boundary = reversed(rectangle(0, 0, 6, 4));
  expectRefused(plan, "-24");
  plan.rooms[0].boundary = polygon({{0, 0}, {1, 0}});
  expectRefused(plan, "it is 0 m2");
  plan = smallPlan();
  plan.rooms[0].details[0].boundary = reversed(rectangle(1, 1, 2, 2));
  expectRefused(plan, "-1 m2");
}

TEST(PlanLoopPolygon, HasAtMostTenThousandChordsAnArcHoweverLargeItIs)
{
  EXPECT_EQ(circle({0, 0}, 1e5).polygon(1e-12).size(), 10000u);
  PlanLoop loop = circle({0, 0}, 1);
  loop.elements[0].radius = 1e300;
  EXPECT_LE(loop.polygon(0.01).size(), 10000u);
  loop.elements[0].radius = std::numeric_limits<double>::infinity();
  EXPECT_LE(loop.polygon(0.01).size(), 10000u);
}

TEST(PlanLoopPolygon, ChordsStayWithinTheTolerance)
{
  for (const double radius : {0.3, 20.0, 1000.0})
    for (const double tolerance : {0.1, 1e-3}) {
      const auto corners = circle({0, 0}, radius).polygon(tolerance);
      const double half = M_PI / static_cast<double>(corners.size());
      EXPECT_LE(radius * (1 - std::cos(half)), tolerance * (1 + 1e-6)) << radius;
      if (corners.size() > 3) {
        const double fewer = M_PI / static_cast<double>(corners.size() - 1);
        EXPECT_GT(radius * (1 - std::cos(fewer)), tolerance * (1 - 1e-6)) << radius;
      }
    }
}

} // namespace
