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
  parameters.most_points = raw.size() / 10;
  refitToRaw(plan, raw.view(), {}, parameters);
  EXPECT_LT(cornerError(plan.rooms[0].boundary, rectangle(0, 0, 4, 3)), 0.002);
  EXPECT_LT(plan.rooms[0].boundary.elements[0].inliers, 2500u);
}

TEST(RefitToRaw, OfAFewRoomsAsManyPointsAsTheirPatchesAskForAreTaken)
{
  RoomPoints raw(0.005, 0.005);
  raw.room(plainRoom());
  const auto inliersFor = [&](std::size_t of_patch, std::size_t enough) {
    Floorplan plan = offPlan();
    RefitParameters parameters;
    parameters.points_per_patch = of_patch;
    parameters.points_per_surface = raw.size();
    parameters.enough_points = enough;
    refitToRaw(plan, raw.view(), {}, parameters);
    EXPECT_LT(cornerError(plan.rooms[0].boundary, rectangle(0, 0, 4, 3)), 0.002);
    return static_cast<double>(plan.rooms[0].boundary.elements[0].inliers);
  };
  const double all = inliersFor(1, raw.size());
  const double tenth = inliersFor(1, raw.size() / 10);
  EXPECT_GT(tenth, 0.08 * all);
  EXPECT_LT(tenth, 0.12 * all);
  EXPECT_GT(inliersFor(300, raw.size() / 10), 2 * tenth) << "the patches ask for more";
  EXPECT_EQ(inliersFor(100000, 1), all);
}

TEST(RefitToRaw, OfADenseSurfaceAsManyPointsAsAreEnoughAreTaken)
{
  RoomPoints raw(0.005, 0.005); // 400 points in a patch of a wall of 1040 patches
  raw.room(plainRoom());
  const auto inliersFor = [&](std::size_t of_patch, std::size_t of_surface) {
    Floorplan plan = offPlan();
    RefitParameters parameters;
    parameters.enough_points = raw.size();
    parameters.points_per_patch = of_patch;
    parameters.points_per_surface = of_surface;
    refitToRaw(plan, raw.view(), {}, parameters);
    EXPECT_LT(cornerError(plan.rooms[0].boundary, rectangle(0, 0, 4, 3)), 0.001);
    return static_cast<double>(plan.rooms[0].boundary.elements[0].inliers);
  };
  const double all = inliersFor(100000, 1);
  EXPECT_GT(all, 150000);
  EXPECT_EQ(inliersFor(1, 1000000), all);
  const double of_patches = inliersFor(100, 1);
  EXPECT_GT(of_patches, 0.2 * all);
  EXPECT_LT(of_patches, 0.3 * all);
  const double of_surface = inliersFor(1, 50000);
  EXPECT_GT(of_surface, 40000);
  EXPECT_LT(of_surface, 55000);
}

TEST(RefitToRaw, OfASlabAsManyPointsOfEachPatchAreTaken)
{
  // Of one half of the floor a tenth as many points were scanned.
  RoomPoints raw(0.005, 0.005);
  int k = 0;
  raw.slab(rectangle(0, 0, 4, 3), 0,
           [&](double x, double) { return x < 2 || k++ % 10 == 0; });
  const auto inliersFor = [&](std::size_t of_patch) {
    Floorplan plan = offPlan();
    RefitParameters parameters;
    parameters.points_per_patch = of_patch;
    parameters.points_per_surface = 1;
    refitToRaw(plan, raw.view(), {}, parameters);
    return static_cast<double>(plan.rooms[0].floor.inliers);
  };
  const double all = inliersFor(100000); // 2,500 in a patch, and 250
  EXPECT_GT(all, 200000);
  const double some = inliersFor(200);
  // By the surface, the sparse half would have a tenth of them.
  EXPECT_GT(some, 25000);
  EXPECT_LT(some, 45000);
}

TEST(RefitToRaw, OfASmallSurfaceBesideLargeOnesAllPointsAreTaken)
{
  RoomPoints raw(0.005, 0.005);
  const PlanLoop l_room =
      polygon({{0, 0}, {4, 0}, {4, 3}, {0.2, 3}, {0.2, 2.9}, {0, 2.9}});
  raw.room(roomOf(l_room, 2.6));
  const auto inliersFor = [&](std::size_t of_patch, std::size_t of_surface) {
    Floorplan plan;
    plan.rooms.push_back(roomOf(l_room, 2.6));
    setSeen(plan.rooms[0].boundary, 0.01);
    RefitParameters parameters;
    parameters.enough_points = raw.size();
    parameters.points_per_patch = of_patch;
    parameters.points_per_surface = of_surface;
    refitToRaw(plan, raw.view(), {}, parameters);
    std::vector<std::size_t> inliers;
    for (const auto& e : plan.rooms[0].boundary.elements)
      inliers.push_back(e.inliers);
    return inliers;
  };
  const std::vector<std::size_t> all = inliersFor(100000, 1);
  const std::vector<std::size_t> some = inliersFor(10, 20000);
  ASSERT_EQ(all.size(), some.size());
  EXPECT_LT(5 * some[0], all[0]) << "4 m";
  EXPECT_EQ(some[3], all[3]) << "0.1 m";
  EXPECT_EQ(some[4], all[4]) << "0.2 m";
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
