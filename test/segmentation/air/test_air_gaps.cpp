// SPDX-License-Identifier: BSD-3-Clause
#include "stairs_scene.h"

#include <gtest/gtest.h>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

constexpr std::uint32_t none = AirGaps::none;

/** A room of 4 m x 3 m, 2.5 m high: 39 x 29 columns of air. */
AirScene
box()
{
  AirScene scene;
  scene.room(0.05, 0.05, 4.05, 3.05, 0.01, 2.51);
  return scene;
}

/** A hall of 5.5 m, with a gallery from x = 4.05 m on. */
AirScene
hallWithGallery()
{
  AirScene scene;
  scene.room(0.05, 0.05, 8.05, 4.05, 0.01, 5.51);
  scene.slabs(4.05, 0.05, 8.05, 4.05, 2.51, 2.81);
  return scene;
}

/** A scene without the points that are hidden. */
AirScene
without(const AirScene& scene, const RoomPoints::InSpace& isHidden)
{
  AirScene seen;
  for (const int i : scene.points.all()) {
    const Eigen::Vector3d p = scene.points[i].cast<double>();
    if (!isHidden(p))
      seen.points.point(p.x(), p.y(), p.z());
  }
  return seen;
}

TEST(AirGaps, OfARoomAreItsColumnsEachLinkedToThoseBesideIt)
{
  const AirScene scene = box();
  const SceneAir air(scene);
  ASSERT_EQ(air.gaps.size(), columns_of_box);
  std::size_t ends = 0;
  for (std::uint32_t g = 0; g < air.gaps.size(); ++g) {
    EXPECT_EQ(air.gaps[g].low, 1) << "above the voxel of the floor";
    EXPECT_EQ(air.gaps[g].high, 50) << "up to that of the ceiling";
    EXPECT_TRUE(air.gaps[g].floor_seen && air.gaps[g].ceiling_seen);
    EXPECT_NEAR(air.gaps.height(g), 2.45, 1e-9);
    for (int d = 0; d < 4; ++d) {
      const std::uint32_t o = air.gaps.link(g, d);
      ends += o == none ? 1 : 0;
      if (o != none) {
        EXPECT_EQ(air.gaps.link(o, (d + 2) % 4), g);
        EXPECT_EQ(air.columns.neighbour(air.gaps[g].column, d), air.gaps[o].column);
        EXPECT_FALSE(air.gaps.isDrop(g, d));
      }
    }
  }
  EXPECT_EQ(ends, 2u * (39 + 29));
  EXPECT_EQ(air.gaps.voidArea(), 0);
}

TEST(AirGaps, ReachACornerBothWaysRound)
{
  const AirScene scene = box();
  const SceneAir air(scene);
  EXPECT_EQ(air.gaps.diagonal(air.at(1, 1, 1), 0), air.at(1.1, 1.1, 1));
  EXPECT_EQ(air.gaps.diagonal(air.at(1, 1, 1), 2), air.at(0.9, 0.9, 1));
  EXPECT_EQ(air.gaps.diagonal(air.at(3.95, 1, 1), 0), none) << "at a wall";
}

TEST(AirGaps, AboveATableAreAirAndBelowItAreNot)
{
  AirScene scene = box();
  scene.slab(1, 1, 2, 2, 0.76);
  const SceneAir air(scene);
  const std::uint32_t above = air.at(1.5, 1.5, 1.5);
  ASSERT_NE(above, none);
  EXPECT_EQ(air.gaps[above].low, 16);
  EXPECT_EQ(air.gaps[above].high, 50);
  EXPECT_EQ(air.at(1.5, 1.5, 0.4), none);
  EXPECT_EQ(air.gaps.size(), columns_of_box);
  EXPECT_NEAR(air.gaps.voidArea(), 1, 1e-9);
  EXPECT_EQ(air.gaps.link(air.at(0.95, 1.5, 1), 0), air.at(1.05, 1.5, 1.5));
}

TEST(AirGaps, OfTwoStoreysAreNotLinkedAndTheSlabBetweenIsNoAir)
{
  AirScene scene = box();
  scene.room(0.05, 0.05, 4.05, 3.05, 2.81, 5.31);
  const SceneAir air(scene);
  ASSERT_EQ(air.gaps.size(), 2 * columns_of_box);
  EXPECT_EQ(air.at(2, 2, 2.65), none);
  EXPECT_NEAR(air.gaps.voidArea(), 0.01 * 41 * 31, 1e-9) << "over the walls, too";
  for (std::uint32_t g = 0; g < air.gaps.size(); ++g)
    for (int d = 0; d < 4; ++d)
      if (const std::uint32_t o = air.gaps.link(g, d); o != none) {
        EXPECT_EQ(air.gaps[g].low, air.gaps[o].low);
      }
}

TEST(AirGaps, AreNoneOfATerraceThatWasSeenThroughADoor)
{
  AirScene with_door = without(box(), [](const Eigen::Vector3d& p) {
    return p.y() > 3.04 && p.x() > 1.5 && p.x() < 2.4 && p.z() > 0.02 && p.z() < 2.1;
  });
  with_door.slab(1.5, 3.05, 2.4, 3.15, 2.11); // the head of the door
  with_door.slab(0.5, 3.05, 3.5, 5.05, 0.01); // the ground outside
  const SceneAir air(with_door);
  EXPECT_NE(air.at(2, 3.05, 1), none) << "in the door";
  for (double y = 3.35; y < 5; y += 0.1)
    EXPECT_EQ(air.at(2, y, 1), none) << y;
}

TEST(AirGaps, OfAHallGoOnBelowAGallery)
{
  const AirScene scene = hallWithGallery();
  const SceneAir air(scene);
  const std::uint32_t hall = air.at(3.95, 2, 4);
  EXPECT_EQ(hall, air.at(3.95, 2, 1));
  EXPECT_EQ(air.gaps.link(hall, 0), air.at(4.05, 2, 1)) << "where its floor goes on";
  EXPECT_FALSE(air.gaps.isDrop(hall, 0));
  EXPECT_EQ(air.gaps.link(air.at(4.05, 2, 4), 2), none);
}

TEST(AirGaps, OverStairsGoOnAboveTheSlabBelowWhichNobodyCanStandOnThem)
{
  AirScene scene;
  addStoreysWithStairs(scene);
  const SceneAir air(scene);
  const std::uint32_t below = air.at(0.55, 1.85, 1.5); // the slab, on the third tread
  const std::uint32_t above = air.at(0.55, 1.85, 4);
  const std::uint32_t next = air.at(0.55, 1.95, 4);
  EXPECT_NE(below, above);
  EXPECT_EQ(next, air.at(0.55, 1.95, 1.5)) << "through the slab";
  EXPECT_EQ(air.gaps.link(next, 3), above);
  EXPECT_EQ(air.gaps.link(below, 1), none);
  EXPECT_EQ(air.gaps.climb(below, 1), next);
  EXPECT_EQ(air.gaps.climb(next, 3), none) << "one climbs up only";
  EXPECT_EQ(air.gaps.climb(air.at(0.55, 1.35, 1.5), 1), none) << "on its foot";
}

TEST(AirGaps, AreLinkedWhereTheyOverlapByHalfOfTheLower)
{
  for (const double floor : {1.01, 2.01}) {
    AirScene scene;
    scene.slabs(0.05, 0.05, 4, 4.05, 0.01, 2.51);
    scene.slab(4, 0.05, 8.05, 4.05, floor);
    scene.slab(4, 0.05, 8.05, 4.05, floor + 2.5);
    const SceneAir air(scene);
    EXPECT_EQ(air.gaps.link(air.at(3.95, 2, 1), 0),
              floor < 1.25 ? air.at(4.05, 2, 3) : none)
        << floor;
  }
}

TEST(AirGaps, ReachASlopeUpToTheWallThoughWhatIsNarrowIsClosed)
{
  // A ceiling that rises by 0.4 to the wall at 4.05 m, and below it a duct with a slit
  // of 20 cm to the other wall.
  AirScene scene;
  const PlanSlab slope = slabAt(2.41, 0.4);
  scene.slab(0.05, 0.05, 4.05, 3.05, 0.01);
  scene.points.slab(rectangle(0.05, 0.05, 4.05, 3.05), slope);
  scene.sides(0.05, 0.05, 4.05, 3.05, 0.01, 4.01);
  scene.hanging(0.25, 0.05, 0.65, 3.05, 2.11, 2.5);
  const VoxelColumns seen(scene.points.view(), {}, 0.1, 0.05, 1);
  VoxelColumns closed = seen;
  closed.closeDots(2, 1);
  const AirParameters parameters;
  const AirGaps lower(closed, closed, parameters);
  const AirGaps gaps(closed, seen, parameters);
  ASSERT_EQ(gaps.size(), lower.size());
  int raised = 0;
  for (std::uint32_t g = 0; g < gaps.size(); ++g) {
    const Eigen::Vector2d p = closed.grid().centre(closed.cellOf(gaps[g].column));
    raised += gaps[g].high > lower[g].high ? 1 : 0;
    EXPECT_TRUE(p.x() > 0.9 || gaps[g].high == lower[g].high) << "in the slit";
    if (p.x() > 1.2 && p.y() > 0.2 && p.y() < 2.9) {
      EXPECT_NEAR(closed.heightOf(gaps[g].high), slope.heightAt(p), 0.11) << p.x();
    }
  }
  EXPECT_GE(raised, 29) << "columns along the wall";
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

TEST(AirGaps, ASlabGoesOnAcrossAHoleInACornerButAStairwellAlongTheWallStaysOpen)
{
  for (const double length : {1.0, 3.0}) {
    const AirScene scene = storeysWithHole(0, 0, 0.9, length);
    const SceneAir air(scene);
    EXPECT_EQ(air.gaps[air.at(0.45, 0.45, 1)].high, length < 2 ? 50 : 106) << length;
  }
}

} // namespace
