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

TEST(AirGaps, AboveAWardrobeAreAir)
{
  AirScene scene;
  scene.slab(0.05, 0.05, 4.05, 2.45, 0.01); // none below it
  scene.slab(0.05, 0.05, 4.05, 3.05, 2.51);
  scene.sides(0.05, 0.05, 4.05, 3.05, 0.01, 2.51);
  scene.wall(0.05, 2.45, 4.05, 2.45, 0.01, 2.11);
  scene.slab(0.05, 2.45, 4.05, 3.05, 2.11);
  const SceneAir air(scene);
  const std::uint32_t above = air.at(2, 2.75, 2.3);
  ASSERT_NE(above, none);
  EXPECT_EQ(air.gaps[above].low, 43);
  EXPECT_TRUE(air.gaps[above].floor_seen);
  EXPECT_EQ(air.at(2, 2.75, 1), none) << "nothing was seen in it";
  EXPECT_EQ(air.gaps.size(), columns_of_box);
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

TEST(AirGaps, AboveASuspendedCeilingAreNoneThoughATileIsMissing)
{
  AirScene scene;
  scene.slabs(0.05, 0.05, 4.05, 3.05, 0.01,
              3.31); // the slab above, seen through the hole
  scene.sides(0.05, 0.05, 4.05, 3.05, 0.01, 3.31);
  scene.points.slab(scene.loop(0.05, 0.05, 4.05, 3.05), 2.51, [](double x, double y) {
    return x < 1.8 || x > 2.4 || y < 1.2 || y > 1.8;
  });
  const SceneAir air(scene);
  const std::uint32_t hole = air.at(2.1, 1.5, 1);
  ASSERT_NE(hole, none);
  EXPECT_EQ(air.gaps[hole].high, 66);
  EXPECT_EQ(air.at(1, 1.5, 3), none) << "0.8 m between the ceilings";
  const std::uint32_t beside = air.at(1.75, 1.5, 1);
  EXPECT_EQ(air.gaps[beside].high, 50);
  EXPECT_EQ(air.gaps.link(beside, 0), air.at(1.85, 1.5, 1));
}

TEST(AirGaps, LeaveAColumnOfTheBuildingEmptyThoughAirIsAroundIt)
{
  AirScene scene = box();
  scene.sides(2.05, 1.05, 2.35, 1.35, 0.01, 2.51);
  // Floor and ceiling under and over it were not seen.
  const AirScene seen = without(scene, [](const Eigen::Vector3d& p) {
    return p.x() > 2.06 && p.x() < 2.34 && p.y() > 1.06 && p.y() < 1.34;
  });
  const SceneAir air(seen);
  EXPECT_EQ(air.at(2.05, 1.2, 1), none);
  EXPECT_EQ(air.at(2.2, 1.2, 1), none);
  EXPECT_EQ(air.gaps.size(), columns_of_box - 16);
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

TEST(AirGaps, DropWhereAFloorEndsAboveAnother)
{
  AirScene scene;
  scene.room(0.05, 0.05, 8.05, 4.05, 0.01, 5.51);
  scene.slab(4.05, 0.05, 8.05, 4.05, 1.51); // a stage
  const SceneAir air(scene);
  const std::uint32_t stage = air.at(4.05, 2, 4);
  ASSERT_EQ(air.gaps.link(stage, 2), air.at(3.95, 2, 4));
  EXPECT_TRUE(air.gaps.isDrop(stage, 2));
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

TEST(AirGaps, AreLinkedMutually)
{
  // A hall of 5.5 m overlaps both the room below a gallery and the air on it.
  const AirScene scene = hallWithGallery();
  const SceneAir air(scene);
  ASSERT_NE(air.at(6, 2, 1), air.at(6, 2, 4));
  std::size_t links = 0;
  for (std::uint32_t g = 0; g < air.gaps.size(); ++g)
    for (int d = 0; d < 4; ++d)
      if (const std::uint32_t o = air.gaps.link(g, d); o != none) {
        ++links;
        ASSERT_EQ(air.gaps.link(o, (d + 2) % 4), g);
      }
  EXPECT_GT(links, 10000u);
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

} // namespace
