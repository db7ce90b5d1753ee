// SPDX-License-Identifier: BSD-3-Clause
#include "refit_plans.h"

#include <pcl/sedr_filters/floorplan_io.h>

#include <gtest/gtest.h>

#include <limits>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

TEST(RefitToRaw, TheSameBytesForAnyNumberOfThreads)
{
  RoomPoints raw(0.01, 0.01);
  raw.room(plainRoom());
  ASSERT_GT(raw.size(), 400000u);
  std::string first;
  for (const unsigned threads : {1u, 2u, 4u}) {
    Floorplan plan = offPlan();
    RefitParameters parameters;
    parameters.threads = threads;
    refitToRaw(plan, raw.view(), {}, parameters);
    const std::string text = floorplanToJson(plan);
    if (first.empty())
      first = text;
    EXPECT_TRUE(text == first) << threads;
  }
}

TEST(RefitToRaw, OfALargeScanEveryKthPointIsTaken)
{
  RoomPoints raw(0.015, 0.005);
  raw.room(plainRoom());
  Floorplan plan = offPlan();
  RefitParameters parameters;
  parameters.max_points = raw.size() / 10;
  refitToRaw(plan, raw.view(), {}, parameters);
  EXPECT_LT(cornerError(plan.rooms[0].boundary, rectangle(0, 0, 4, 3)), 0.002);
  EXPECT_LT(plan.rooms[0].boundary.elements[0].inliers, 2500u);
}

TEST(RefitToRaw, NoPointsOrPointsElsewhereLeaveThePlanAsItIs)
{
  const std::string was = floorplanToJson(offPlan());
  const auto expectUnchanged = [&](const RoomPoints& raw) {
    Floorplan plan = offPlan();
    const RefitReport report = refitToRaw(plan, raw.view());
    EXPECT_EQ(report.curves, 0u);
    EXPECT_EQ(report.slabs, 0u);
    EXPECT_TRUE(floorplanToJson(plan) == was);
  };
  expectUnchanged(RoomPoints());
  RoomPoints far;
  for (const double shift : {100.0, 1e7, 1e30})
    for (int i = 0; i < 1000; ++i)
      far.point(shift + i, -shift, shift);
  expectUnchanged(far);
  RoomPoints not_a_number;
  for (int i = 0; i < 1000; ++i)
    not_a_number.point(std::numeric_limits<double>::quiet_NaN(), 1, 1);
  expectUnchanged(not_a_number);
  Floorplan empty;
  EXPECT_EQ(refitToRaw(empty, far.view()).curves, 0u);
}

TEST(RefitToRaw, APlanWithAnEmptyLoopStaysAsItIs)
{
  RoomPoints raw(0.02);
  raw.room(plainRoom());
  Floorplan plan = offPlan();
  plan.rooms[0].details.emplace_back();
  const std::string was = floorplanToJson(plan);
  EXPECT_EQ(refitToRaw(plan, raw.view()).problem, "room 1 has a loop of 0 elements");
  EXPECT_TRUE(floorplanToJson(plan) == was);
}

TEST(RefitToRaw, PointsThatAreNotFiniteOrNotIndexedDoNotCount)
{
  RoomPoints raw(0.02);
  const PlanRoom truth = plainRoom();
  raw.room(truth);
  const std::vector<int> indices = raw.all();
  raw.room(roomOf(rectangle(-0.01, -0.01, 4.01, 3.01), 2.61)); // not indexed
  raw.room(roomOf(rectangle(-0.01, -0.01, 4.01, 3.01), 2.61));
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::vector<int> with_bad = indices;
  for (int i = 0; i < 100; ++i)
    with_bad.push_back(raw.point(2, nan, 2));
  for (const auto& chosen : {indices, with_bad}) {
    Floorplan plan = offPlan();
    refitToRaw(plan, raw.view(), chosen);
    EXPECT_LT(cornerError(plan.rooms[0].boundary, rectangle(0, 0, 4, 3)), 1e-5);
  }
}

} // namespace
