// SPDX-License-Identifier: BSD-3-Clause
#include "air_scene.h"

#include <gtest/gtest.h>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

bool
isAside(double x, double y)
{
  return x < 2 || x > 4 || y < 1 || y > 3;
}

bool
always(double /*x*/, double /*y*/)
{
  return true;
}

TEST(SlabFaces, AFloorIsFoundThoughThatOfTheStoreyBelowWasHiddenAtTheSamePlace)
{
  AirScene scene;
  scene.points.slab(scene.loop(0.05, 0.05, 6.05, 4.05), 0.01, isAside);
  scene.slab(0.05, 0.05, 6.05, 4.05, 2.51);
  scene.points.slab(scene.loop(0.05, 0.05, 6.05, 4.05), 2.81, isAside);
  scene.slab(0.05, 0.05, 6.05, 4.05, 5.31);
  scene.sides(0.05, 0.05, 6.05, 4.05, 0.01, 5.31);
  const SceneAir air(scene);
  EXPECT_EQ(air.gaps[air.at(3, 2, 4)].low, 57);
  ASSERT_NE(air.at(3, 2, 1), AirGaps::none);
  EXPECT_EQ(air.gaps[air.at(3, 2, 1)].low, 1);
}

TEST(SlabFaces, AFloorIsFoundAboveATable)
{
  AirScene scene = storeysWithSlab(always, isAside);
  scene.slab(2.55, 1.55, 3.55, 2.55, 0.76); // no headroom above it
  const SceneAir air(scene);
  EXPECT_EQ(air.gaps[air.at(3, 2, 4)].low, 57);
}

TEST(SlabFaces, AFloorThatWasNotSeenAtAllLiesAsHighAsThoseOfOtherRooms)
{
  AirScene scene = storeysWithSlab(always, always);
  scene.room(8.05, 0.05, 12.05, 4.05, 0.01, 5.31);
  scene.slab(8.05, 0.05, 12.05, 4.05, 2.51);
  const SceneAir air(scene);
  const AirGap& upper = air.gaps[air.at(10, 2, 4)];
  EXPECT_EQ(upper.low, 57);
  EXPECT_FALSE(upper.floor_seen);
}

TEST(SlabFaces, AFloorThatWasNotSeenIsFoundAboveARibbedCeiling)
{
  AirScene scene = storeysWithSlab(always, isAside);
  for (double y = 0.55; y < 4; y += 0.6)
    scene.hanging(0.05, y, 6.05, y + 0.2, 2.21, 2.51);
  const SceneAir air(scene);
  for (const double y : {1.65, 1.95, 2.25, 2.55})
    EXPECT_EQ(air.gaps[air.at(3, y, 4)].low, 57) << "at " << y;
  EXPECT_EQ(air.gaps[air.at(3, 1.85, 1)].high, 44) << "the rib stays";
}

} // namespace
