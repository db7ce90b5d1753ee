// SPDX-License-Identifier: BSD-3-Clause
#include "room_points.h"

#include "sedr_segmentation/src/rooms/room_planes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

std::vector<int>
both(std::vector<int> a, const std::vector<int>& b)
{
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

TEST(RoomPlanes, ACeilingIsAtTheHeightThatMostOfItHas)
{
  RoomPoints points;
  const auto most = points.slab(rectangle(0, 0, 4, 3), 2.5);
  const auto soffit = points.slab(rectangle(4, 0, 6, 3), 2.2);
  EXPECT_NEAR(ceilingLevel(points.view(), both(soffit, most)), 2.5, 0.025);
  EXPECT_EQ(ceilingLevel(points.view(), {}), 0);
}

TEST(RoomPlanes, AFloorIsTheLowestHeightThatAFifthOfItHas)
{
  RoomPoints points;
  const auto floor = points.slab(rectangle(0, 0, 1, 1), 0.1);
  const auto platform = points.slab(rectangle(1, 0, 4, 1), 0.5);
  const auto pit = points.slab(rectangle(0, 2, 0.5, 3), -0.4);
  EXPECT_NEAR(floorLevel(points.view(), both(both(platform, floor), pit)), 0.1, 0.025);
  EXPECT_NEAR(floorLevel(points.view(), both(platform, pit)), 0.5, 0.025)
      << "a pit of a seventh is a hole in it";
}

TEST(RoomPlanes, TheMainPlaneIsTiltedAsItsSheetDoesAndLeavesOtherHeightsOut)
{
  RoomPoints points;
  const double slope = std::tan(1 * M_PI / 180);
  PlanSlab plane = slabAt(2.5);
  plane.plane = Eigen::Vector4d(-slope, 0, 1, -2.5) / std::hypot(slope, 1);
  const auto level = points.slab(rectangle(0, 0, 4, 3), plane);
  const auto higher = points.slab(rectangle(4, 0, 9, 3), 2.9);
  const PlanSlab main =
      mainPlane(points.view(), both(higher, level), 2.5, RoomPlaneParameters());
  EXPECT_NEAR(main.heightAt({0, 0}), 2.5, 0.002);
  EXPECT_NEAR(main.heightAt({4, 3}), 2.5 + 4 * slope, 0.002);
  EXPECT_EQ(pointsOn(points.view(), both(level, higher), main, 0.01), level);
}

TEST(RoomPlanes, AHiddenCeilingGoesOnInTheMainPlaneWhereItIsInferredNearIt)
{
  const CellGrid grid(0.05);
  RoomPoints points;
  const CellSet seen(grid, points.view(), points.slab(rectangle(0, 0, 0.05, 0.1), 2.5));
  std::vector<RoomColumn> columns(3);
  columns[0] = {{0, 0}, 0, 2.45F, true, false};
  columns[1] = {{1, 0}, 0, 2.1F, true, false};
  columns[2] = {{2, 0}, 0, 2.5F, true, true};
  const auto hidden = hiddenCeiling(columns, CellGrid(0.1), grid, seen, slabAt(2.5));
  ASSERT_EQ(hidden.size(), 6u) << "two of the four cells of the first were seen";
  for (const Eigen::Vector3f& place : hidden) {
    EXPECT_FLOAT_EQ(place.z(), place.x() < 0.1F ? 2.5F : 2.1F);
    EXPECT_GT(place.x(), 0.05F);
    EXPECT_LT(place.x(), 0.2F);
  }
}

} // namespace
