// SPDX-License-Identifier: BSD-3-Clause
#include "air_scene.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

TEST(AirGaps, TakeAFloorThatWasHiddenFromTheirNeighboursAndTellIt)
{
  AirScene scene;
  scene.points.slab(scene.loop(0.05, 0.05, 4.05, 3.05), 0.01, [](double x, double y) {
    return x < 1 || x > 3 || y > 1.5; // nothing up to a wall
  });
  scene.slab(0.05, 0.05, 4.05, 3.05, 2.51);
  scene.sides(0.05, 0.05, 4.05, 3.05, 0.01, 2.51);
  const SceneAir air(scene);
  ASSERT_EQ(air.gaps.size(), columns_of_box);
  for (std::uint32_t g = 0; g < air.gaps.size(); ++g) {
    const Eigen::Vector2d p =
        air.columns.grid().centre(air.columns.cellOf(air.gaps[g].column));
    const bool is_hidden = p.x() > 1 && p.x() < 3 && p.y() < 1.5;
    EXPECT_EQ(air.gaps[g].floor_seen, !is_hidden) << p.transpose();
    EXPECT_TRUE(air.gaps[g].ceiling_seen);
    EXPECT_EQ(air.gaps[g].low, 1);
    EXPECT_EQ(air.gaps[g].high, 50);
  }
}

TEST(AirGaps, TakeACeilingThatWasHiddenFromTheirNeighboursAndTellIt)
{
  AirScene scene;
  scene.slab(0.05, 0.05, 4.05, 3.05, 0.01);
  scene.points.slab(scene.loop(0.05, 0.05, 4.05, 3.05), 2.51,
                    [](double x, double y) { return x < 1 || x > 3 || y > 1.5; });
  scene.sides(0.05, 0.05, 4.05, 3.05, 0.01, 2.51);
  const SceneAir air(scene);
  ASSERT_EQ(air.gaps.size(), columns_of_box);
  const AirGap& hidden = air.gaps[air.at(2, 1, 1)];
  EXPECT_FALSE(hidden.ceiling_seen);
  EXPECT_TRUE(hidden.floor_seen);
  EXPECT_EQ(hidden.high, 50);
  EXPECT_TRUE(air.gaps[air.at(2, 2, 1)].ceiling_seen);
}

TEST(AirGaps, EndBelowAWallOfWhichFurnitureHidesTheFoot)
{
  for (const auto& [depth, high] : {std::pair(0.3, 44), {0.4, 42}}) {
    AirScene scene;
    scene.points.slab(scene.loop(0.05, 0.05, 4.05, 3.05), 0.01,
                      [](double x, double) { return x < 1.5 || x > 2.6; });
    scene.slab(0.05, 0.05, 4.05, 3.05, 2.51);
    scene.sides(0.05, 0.05, 4.05, 3.05, 0.01, 2.51);
    scene.wall(2.05, 0.05, 2.05, 3.05, 2.51 - depth, 2.51);
    const SceneAir air(scene);
    const std::uint32_t below = air.at(2.05, 1.5, 1);
    ASSERT_NE(below, AirGaps::none) << depth;
    EXPECT_EQ(air.gaps[below].high, high) << depth;
    EXPECT_EQ(air.gaps[air.at(1.85, 1.5, 1)].high, 50) << depth;
  }
}

TEST(AirGaps, GoOnWhereTheFloorIsHiddenBehindWhatHangsFromTheCeiling)
{
  for (const double depth : {0.15, 0.2, 0.4}) {
    AirScene scene;
    scene.points.slab(scene.loop(0.05, 0.05, 8.05, 3.05), 0.01,
                      [](double x, double) { return x < 5; });
    scene.slab(0.05, 0.05, 8.05, 3.05, 2.51);
    scene.sides(0.05, 0.05, 8.05, 3.05, 0.01, 2.51);
    scene.hanging(6.05, 0.05, 6.15, 3.05, 2.51 - depth, 2.51);
    const SceneAir air(scene);
    EXPECT_EQ(air.gaps.size(), std::size_t{79} * 29) << depth;
    for (const double x : {5.5, 7.5}) {
      ASSERT_NE(air.at(x, 1.5, 1), AirGaps::none) << depth << ' ' << x;
      EXPECT_EQ(air.gaps[air.at(x, 1.5, 1)].high, 50) << depth << ' ' << x;
    }
  }
}

/** A closet of 2 m x 2 m; a scanner in it sees the floor from 0.7 m on, the ceiling
 * from `blind` m on, and no floor towards x = 2.05. */
AirScene
closetAroundScanner(double blind)
{
  AirScene scene;
  const auto isFar = [](double least) {
    return
        [least](double x, double y) { return std::hypot(x - 1.05, y - 1.05) > least; };
  };
  scene.points.slab(scene.loop(0.05, 0.05, 2.05, 2.05), 0.01,
                    [&](double x, double y) { return isFar(0.7)(x, y) && x < 1.75; });
  scene.points.slab(scene.loop(0.05, 0.05, 2.05, 2.05), 2.51, isFar(blind));
  scene.sides(0.05, 0.05, 2.05, 2.05, 0.01, 2.51);
  return scene;
}

TEST(AirGaps, GoOnAroundAScannerThatSawNeitherTheFloorBelowNorTheCeilingAboveIt)
{
  const AirScene scene = closetAroundScanner(0.45);
  const SceneAir air(scene);
  EXPECT_EQ(air.gaps.size(), std::size_t{19} * 19);
  const std::uint32_t g = air.at(1.05, 1.05, 1);
  ASSERT_NE(g, AirGaps::none);
  EXPECT_FALSE(air.gaps[g].floor_seen);
  EXPECT_FALSE(air.gaps[g].ceiling_seen);
  EXPECT_EQ(air.gaps[g].low, 1);
  EXPECT_EQ(air.gaps[g].high, 50);
}

TEST(AirGaps, DoNotGoOnWhereNeitherFloorNorCeilingWasSeenAsFarAsAWall)
{
  AirScene scene; // 0.6 m along a wall that was not seen there either
  const auto isSeen = [](double x, double y) {
    return x < 3.5 || std::abs(y - 1.5) > 0.3;
  };
  scene.points.slab(scene.loop(0.05, 0.05, 4.05, 3.05), 0.01, isSeen);
  scene.points.slab(scene.loop(0.05, 0.05, 4.05, 3.05), 2.51, isSeen);
  for (const auto& e : scene.loop(0.05, 0.05, 4.05, 3.05).elements)
    scene.points.wall(e, 0.01, 2.51, [&](double along, double) {
      const Eigen::Vector2d p = e.pointAt(along);
      return isSeen(p.x(), p.y());
    });
  const SceneAir air(scene);
  EXPECT_NE(air.at(3.2, 1.5, 1), AirGaps::none);
  EXPECT_EQ(air.at(3.8, 1.5, 1), AirGaps::none);
}

TEST(AirGaps, BesideAVoidGoOnInItsLowerStorey)
{
  AirScene scene; // the upper storey beside the void is the higher
  scene.room(0.05, 0.05, 8.05, 6.05, 0.01, 6.01);
  scene.slabs(5.05, 0.05, 8.05, 6.05, 2.51, 2.81);
  scene.wall(5.05, 0.05, 5.05, 6.05, 2.51, 2.81);
  const SceneAir air(scene);
  const std::uint32_t lower = air.at(6.5, 3, 1);
  const AirGap& in_void = air.gaps[air.at(2.5, 3, 1)];
  EXPECT_EQ(air.gaps.goingOnFrom(in_void, air.gaps[lower].column), lower);
}

/** Two rooms above each other; in what was seen of the slab between them is a hole. */
AirScene
storeysWithHole(double x0, double y0, double x1, double y1)
{
  const auto isSeen = [&](double x, double y) {
    return x < x0 || x > x1 || y < y0 || y > y1;
  };
  return storeysWithSlab(isSeen, isSeen);
}

TEST(AirGaps, ASlabGoesOnAcrossAHoleInWhatWasSeenOfIt)
{
  const AirScene scene = storeysWithHole(2, 1, 2.9, 1.9);
  const SceneAir air(scene);
  ASSERT_EQ(air.gaps.size(), std::size_t{2} * 59 * 39);
  const AirGap& lower = air.gaps[air.at(2.45, 1.45, 1)];
  EXPECT_TRUE(lower.floor_seen);
  EXPECT_FALSE(lower.ceiling_seen);
  EXPECT_EQ(lower.high, 50);
  const AirGap& upper = air.gaps[air.at(2.45, 1.45, 4)];
  EXPECT_FALSE(upper.floor_seen);
  EXPECT_TRUE(upper.ceiling_seen);
  EXPECT_EQ(upper.low, 57);
}

TEST(AirGaps, AVoidOverTwoStoreysStaysOpen)
{
  const AirScene scene = storeysWithHole(2, 1, 3.9, 2.9);
  const SceneAir air(scene);
  const AirGap& through = air.gaps[air.at(2.95, 1.95, 1)];
  EXPECT_EQ(through.low, 1);
  EXPECT_EQ(through.high, 106);
  EXPECT_EQ(air.at(2.95, 1.95, 1), air.at(2.95, 1.95, 4));
}

TEST(AirGaps, ASlabGoesOnAcrossAHoleInACornerButAStairwellAlongTheWallStaysOpen)
{
  for (const double length : {1.0, 3.0}) {
    const AirScene scene = storeysWithHole(0, 0, 0.9, length);
    const SceneAir air(scene);
    EXPECT_EQ(air.gaps[air.at(0.45, 0.45, 1)].high, length < 2 ? 50 : 106) << length;
  }
}

TEST(AirGaps, APlateInASmallRoomIsNoSlabWithAHoleAroundIt)
{
  AirScene scene; // a shelf, or what is seen at the edge of one thing before another
  scene.room(0.05, 0.05, 1.25, 1.25, 0.01, 5.01);
  scene.slab(0.5, 0.5, 0.8, 0.8, 2.51);
  const SceneAir air(scene);
  const AirGap& beside = air.gaps[air.at(0.3, 0.3, 1)];
  EXPECT_EQ(beside.low, 1);
  EXPECT_EQ(beside.high, 100);
}

TEST(AirGaps, TheVoidOfASlabIsNoAirThoughItsLowerSideHasAHole)
{
  const auto isSeen = [](double x, double y) {
    return x < 2 || x > 2.6 || y < 1 || y > 1.6;
  };
  AirScene open;
  open.slab(0.05, 0.05, 4.05, 3.05, 0.01);
  open.points.slab(open.loop(0.05, 0.05, 4.05, 3.05), 2.51, isSeen);
  open.slab(0.05, 0.05, 4.05, 3.05, 3.01); // above a suspended ceiling
  open.sides(0.05, 0.05, 4.05, 3.05, 0.01, 3.01);
  const SceneAir air(open);
  EXPECT_EQ(air.gaps.size(), columns_of_box);
  EXPECT_NEAR(air.gaps.voidArea(), columns_of_box * 0.01, 0.6);
}

} // namespace
