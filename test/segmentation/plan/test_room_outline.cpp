// SPDX-License-Identifier: BSD-3-Clause
#include "ceiling_scene.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

TEST(OutlineRoom, OfAWholeCeilingIsItsCells)
{
  const RoomOutline outline = CeilingScene().outline();
  EXPECT_TRUE(isWholeRoom(outline.room));
  EXPECT_TRUE(outline.columns.empty());
  EXPECT_NEAR(areaOfCells(outline.room), 12, 0.01);
}

TEST(OutlineRoom, WhatWasNotHitIsClosed)
{
  const RoomOutline outline = CeilingScene([](double x, double y) {
                                return std::fmod(std::round(x * 20), 4) != 0 &&
                                       std::fmod(std::round(y * 20), 3) != 0;
                              }).outline();
  EXPECT_NEAR(areaOfCells(outline.room), 12, 0.6) << "up to the outermost seen row";
  EXPECT_EQ(labelRegions(outline.room, false).sizes.size(), 1u);
  EXPECT_EQ(enclosedCells(outline.room).count(), 0u);
  EXPECT_TRUE(outline.columns.empty());
}

TEST(OutlineRoom, TheHoleOfALampIsFilled)
{
  CeilingScene scene(
      [](double x, double y) { return !isWithin(x, y, 1.5, 1, 2.1, 1.6); });
  scene.box(1.5, 1, 2.1, 1.6, 2.1, room_height);
  const RoomOutline outline = scene.outline();
  EXPECT_TRUE(isWholeRoom(outline.room));
  EXPECT_TRUE(outline.columns.empty());
}

TEST(OutlineRoom, AHoleTooLargeForWhatHangsThereStaysThoughNoWallIsAroundIt)
{
  for (const bool is_court : {true, false}) { // 4.2 or 3.2 square metres
    const double to = is_court ? 3.1 : 2.6;
    const CeilingScene scene(
        [&](double x, double y) { return !isWithin(x, y, 1, 0.5, to, 2.5); });
    EXPECT_EQ(scene.outline().columns.size(), is_court ? 1u : 0u);
  }
}

TEST(OutlineRoom, WhatIsFarFromTheLargestPartIsTold)
{
  EXPECT_EQ(CeilingScene().outline().lost_area, 0);
  const RoomOutline outline =
      CeilingScene([](double x, double) { return x < 2.51 || x > 3.51; }).outline();
  EXPECT_NEAR(areaOfCells(outline.room), 7.5, 0.01);
  EXPECT_NEAR(outline.lost_area, 1.5, 0.01);
}

TEST(OutlineRoom, AFalseNotchIsClosed)
{
  // A cupboard at the wall that ends below the ceiling hides a part of the ceiling.
  for (const double top : {1.2, 1.9, 2.1}) {
    CeilingScene scene(
        [](double x, double y) { return !isWithin(x, y, 1.5, 0, 2.1, 0.5); });
    scene.box(1.51, 0.01, 2.11, 0.51, 0, top);
    const CellMask room = scene.outline().room;
    EXPECT_EQ(room.at(CellGrid(0.05).at(1.8, 0.2)), 1) << top;
    // The closing disc leaves a shallow dent at the wall.
    EXPECT_NEAR(areaOfCells(room), 12, 0.06) << top;
  }
}

TEST(OutlineRoom, ANotchWithAWallAroundStaysUnderASoffitToo)
{
  // The soffit is 0.5 m below the ceiling along the wall; a pillar ends at it.
  const double soffit = 2.0;
  CeilingScene scene([](double, double y) { return y > 0.81; }, 1.5, 2.1);
  const auto under = scene.points.slab(
      rectangle(0.01, 0.01, 4.01, 0.81), soffit,
      [](double x, double y) { return !isWithin(x, y, 1.51, 0, 2.11, 0.51); });
  scene.points.wall(segment({4.01, 0.81}, {0.01, 0.81}), soffit, room_height);
  scene.ceiling = joined(scene.ceiling, under);
  for (const double x : {1.51, 2.11})
    scene.points.wall(segment({x, 0.01}, {x, 0.51}), 0, soffit);
  scene.points.wall(segment({1.51, 0.51}, {2.11, 0.51}), 0, soffit);
  const RoomOutline outline = scene.outline();
  EXPECT_EQ(outline.room.at(CellGrid(0.05).at(1.8, 0.2)), 0);
  EXPECT_NEAR(areaOfCells(outline.room), 12 - 0.3, 0.06);
}

TEST(OutlineRoom, WhatWasSeenThroughAnOpeningIsCutOff)
{
  CeilingScene scene;
  const auto beyond = scene.points.slab(rectangle(2.01, 3.01, 2.26, 4.01), room_height);
  scene.ceiling = joined(scene.ceiling, beyond);
  const CellMask room = scene.outline().room;
  EXPECT_EQ(room.at(CellGrid(0.05).at(2.13, 3.35)), 0);
  EXPECT_NEAR(areaOfCells(room), 12, 0.08) << "but for its mouth";
}

TEST(OutlineRoom, WhatWasSeenInAMirrorIsCutOff)
{
  CeilingScene scene;
  const auto beyond = scene.points.slab(rectangle(1.51, 3.01, 2.21, 4.31), room_height);
  scene.ceiling = joined(scene.ceiling, beyond);
  const CellMask room = scene.outline().room;
  EXPECT_EQ(room.at(CellGrid(0.05).at(1.86, 3.5)), 0);
  EXPECT_NEAR(areaOfCells(room), 12, 0.2) << "but for its mouth";
}

TEST(OutlineRoom, AnAlcoveOfWhichOneWallWasSeenStays)
{
  CeilingScene scene;
  const auto alcove = scene.points.slab(rectangle(1.51, 3.01, 2.21, 4.31), room_height);
  scene.ceiling = joined(scene.ceiling, alcove);
  scene.points.wall(segment({2.21, 3.01}, {2.21, 4.31}), 0, room_height);
  EXPECT_NEAR(areaOfCells(scene.outline().room), 12 + 0.7 * 1.3, 0.1);
}

TEST(OutlineRoom, ANarrowNicheWithWallsStays)
{
  CeilingScene scene;
  const auto niche = scene.points.slab(rectangle(2.01, 3.01, 2.31, 4.01), room_height);
  scene.ceiling = joined(scene.ceiling, niche);
  for (const auto& e :
       {segment({2.31, 3.01}, {2.31, 4.01}), segment({2.31, 4.01}, {2.01, 4.01}),
        segment({2.01, 4.01}, {2.01, 3.01})})
    scene.points.wall(e, 0, room_height);
  EXPECT_NEAR(areaOfCells(scene.outline().room), 12.3, 0.05);
}

TEST(OutlineRoom, AThinPartitionThatEndsInTheRoomStays)
{
  for (const double thickness : {0.05, 0.1, 0.15}) {
    SCOPED_TRACE(thickness);
    CeilingScene scene([&](double x, double y) {
      return !isWithin(x, y, 2.02, 1, 2.02 + thickness, 4);
    });
    scene.box(2.02, 1, 2.02 + thickness, 3.01, 0, room_height);
    const RoomOutline outline = scene.outline();
    EXPECT_TRUE(outline.columns.empty());
    for (double y = 1.1; y < 3; y += 0.05)
      EXPECT_FALSE(outline.room.at(CellGrid(0.05).at(2.02 + thickness / 2, y))) << y;
    EXPECT_NEAR(areaOfCells(outline.room), 12 - 2 * thickness, 0.2);
  }
}

TEST(OutlineRoom, AThinPartitionShortOfTheCeilingIsNone)
{
  CeilingScene scene(
      [](double x, double y) { return !isWithin(x, y, 2.02, 1, 2.12, 4); });
  scene.box(2.02, 1, 2.12, 3.01, 0, 2);
  EXPECT_NEAR(areaOfCells(scene.outline().room), 12, 0.03);
}

TEST(OutlineRoom, OnlyTheLargestPartIsTheRoom)
{
  CeilingScene scene;
  const auto elsewhere = scene.points.slab(rectangle(6, 0, 7, 3), room_height);
  scene.ceiling = joined(scene.ceiling, elsewhere);
  EXPECT_TRUE(isWholeRoom(scene.outline().room));
}

} // namespace
