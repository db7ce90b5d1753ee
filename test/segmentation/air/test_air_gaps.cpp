// SPDX-License-Identifier: BSD-3-Clause
#include "air_scene.h"
#include "stairs_scene.h"

#include <gtest/gtest.h>

#include <cmath>

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

/** A room of 4 m x 3 m, 2.5 m high, and in it points at 2 m, in every second row and
 * column of those that a surface would have. */
AirScene
roomWithLayer(const PlanLoop& loop)
{
  AirScene scene;
  scene.room(0.05, 0.05, 4.05, 3.05, 0.01, 2.51);
  scene.points.slab(loop, 2.01, [](double x, double y) {
    return std::lround(x / 0.05 - 0.5) % 2 == 0 && std::lround(y / 0.05 - 0.5) % 2 == 0;
  });
  return scene;
}

/** Height of the air over a place, metres, with or without a look at veils. */
double
heightAt(const AirScene& scene, double x, double y, bool knows_veils)
{
  const VoxelColumns fine(scene.points.view(), {}, 0.05, 0.05, 1);
  const VoxelColumns columns = fine.halved(1);
  const AirGaps air(columns, columns, SceneAir::parametersFor(1),
                    knows_veils ? &fine : nullptr);
  const std::uint32_t column = columns.columnAt(columns.grid().at(x, y));
  return air.height(air.first(column));
}

TEST(Veils, EndNoAirWhereTheCeilingIsSeenThroughThem)
{
  const AirScene scene = roomWithLayer(rectangle(1.05, 1.05, 2.05, 2.05));
  EXPECT_NEAR(heightAt(scene, 1.5, 1.5, false), 1.95, 1e-9) << "up to the points";
  EXPECT_NEAR(heightAt(scene, 1.5, 1.5, true), 2.45, 1e-9) << "up to the ceiling";
}

TEST(Veils, AreNoHeadsOfOpeningsInThickWalls)
{
  AirScene scene = roomWithLayer(rectangle(1.05, 1.05, 1.55, 2.05));
  scene.sides(1.05, 1.05, 1.55, 2.05, 2.01, 2.51);
  EXPECT_NEAR(heightAt(scene, 1.3, 1.5, true), 1.95, 1e-9);
}

} // namespace
