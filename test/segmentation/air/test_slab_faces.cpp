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

TEST(SlabFaces, AFloorThatWasNotSeenIsNotTheCeilingBelowIt)
{
  const AirScene scene = storeysWithSlab(always, isAside);
  const SceneAir air(scene);
  const AirGap& upper = air.gaps[air.at(3, 2, 4)];
  EXPECT_EQ(upper.low, 57);
  EXPECT_FALSE(upper.floor_seen);
  EXPECT_TRUE(upper.ceiling_seen);
  const AirGap& lower = air.gaps[air.at(3, 2, 1)];
  EXPECT_EQ(lower.high, 50);
  EXPECT_TRUE(lower.ceiling_seen);
  EXPECT_TRUE(air.gaps[air.at(1, 2, 4)].floor_seen) << "beside";
}

TEST(SlabFaces, ACeilingThatWasNotSeenIsNotTheFloorAboveIt)
{
  const AirScene scene = storeysWithSlab(isAside, always);
  const SceneAir air(scene);
  const AirGap& lower = air.gaps[air.at(3, 2, 1)];
  EXPECT_EQ(lower.high, 50);
  EXPECT_FALSE(lower.ceiling_seen);
  const AirGap& upper = air.gaps[air.at(3, 2, 4)];
  EXPECT_EQ(upper.low, 57);
  EXPECT_TRUE(upper.floor_seen);
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

TEST(SlabFaces, FloorsThatWereHiddenAtTheSamePlaceOfTwoStoreysAreBothFound)
{
  AirScene scene;
  scene.slab(0.05, 0.05, 6.05, 4.05, 0.01);
  for (const double ceiling : {2.51, 5.31}) {
    scene.slab(0.05, 0.05, 6.05, 4.05, ceiling);
    scene.points.slab(scene.loop(0.05, 0.05, 6.05, 4.05), ceiling + 0.3, isAside);
  }
  scene.slab(0.05, 0.05, 6.05, 4.05, 8.11);
  scene.sides(0.05, 0.05, 6.05, 4.05, 0.01, 8.11);
  const SceneAir air(scene);
  const AirGap& second = air.gaps[air.at(3, 2, 4)];
  EXPECT_EQ(second.low, 57);
  EXPECT_EQ(second.high, 106);
  EXPECT_FALSE(second.floor_seen);
  EXPECT_TRUE(second.ceiling_seen);
  const AirGap& third = air.gaps[air.at(3, 2, 7)];
  EXPECT_EQ(third.low, 113);
  EXPECT_FALSE(third.floor_seen);
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

TEST(SlabFaces, FurnitureAlongTheRimIsNotTakenForTheFloor)
{
  AirScene scene = storeysWithSlab(always, isAside);
  // A sideboard along three sides of the area that it hides.
  scene.slab(1.55, 0.55, 2.05, 3.45, 3.71);
  scene.slab(2.05, 0.55, 4.05, 1.05, 3.71);
  scene.slab(2.05, 3.05, 4.05, 3.45, 3.71);
  const SceneAir air(scene);
  EXPECT_EQ(air.gaps[air.at(3, 2, 4)].low, 57);
}

TEST(SlabFaces, ABeamBelowTheSurfaceDoesNotMakeAFloorOfIt)
{
  AirScene scene = storeysWithSlab(always, isAside);
  scene.slab(2.05, 1.05, 2.35, 3.05, 2.21);
  const SceneAir air(scene);
  EXPECT_EQ(air.gaps[air.at(3, 2, 4)].low, 57);
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

TEST(SlabFaces, APlateWithoutASlabBesideItStaysAsItWasSeen)
{
  AirScene scene;
  scene.room(0.05, 0.05, 6.05, 4.05, 0.01, 5.31);
  scene.slab(0.05, 0.05, 6.05, 4.05, 2.66);
  const SceneAir air(scene);
  EXPECT_EQ(air.gaps[air.at(3, 2, 1)].high, 53);
  EXPECT_EQ(air.gaps[air.at(3, 2, 4)].low, 54);
  EXPECT_TRUE(air.gaps[air.at(3, 2, 1)].ceiling_seen);
  EXPECT_TRUE(air.gaps[air.at(3, 2, 4)].floor_seen);
}

TEST(SlabFaces, AThinGalleryIsNoThickerThanSlabsOfOtherRoomsAtItsHeight)
{
  AirScene scene = storeysWithSlab(always, always);
  scene.room(8.05, 0.05, 14.05, 4.05, 0.01, 5.31);
  scene.slabs(8.05, 0.05, 10.05, 4.05, 2.71, 2.81);
  const SceneAir air(scene);
  const AirGap& lower = air.gaps[air.at(9, 2, 1)];
  EXPECT_EQ(lower.high, 54);
  EXPECT_TRUE(lower.ceiling_seen);
}

TEST(SlabFaces, StairsBesideASlabKeepTheirTreads)
{
  AirScene scene;
  scene.room(0.05, 0.05, 8.05, 3.05, 0.01, 5.31);
  scene.slabs(4.05, 0.05, 8.05, 3.05, 2.51, 2.81);
  for (int tread = 0; tread < 12; ++tread) // down from the slab, seen from both sides
    scene.slab(4.05 - 0.25 * (tread + 1), 0.05, 4.05 - 0.25 * tread, 3.05,
               2.66 - 0.18 * tread);
  const SceneAir air(scene);
  const std::uint32_t above = air.at(3.2, 1.5, 3.5);
  ASSERT_NE(above, AirGaps::none);
  EXPECT_TRUE(air.gaps[above].floor_seen);
  EXPECT_NEAR(air.columns.heightOf(air.gaps[above].low), 2.15, 0.06);
}

} // namespace
