// SPDX-License-Identifier: BSD-3-Clause
// Where the air of rooms ends, though a part of what ends it was hidden or is a veil.
#include "building_scene.h"

#include <gtest/gtest.h>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** A gap in a scene, by a place in it and its ends; NaN: any. */
struct ExpectedGap {
  Eigen::Vector3d at;
  double floor;
  double ceiling;
};

constexpr double any = std::numeric_limits<double>::quiet_NaN();

/** Expects gaps with their ends to a voxel of 5 cm. */
void
expectGaps(const char* what,
           const AirScene& scene,
           const std::vector<ExpectedGap>& gaps)
{
  const Found found(scene);
  for (const ExpectedGap& gap : gaps) {
    SCOPED_TRACE(testing::Message() << what << " at " << gap.at.transpose());
    const auto [room, column] = found.gapAt(gap.at.x(), gap.at.y(), gap.at.z());
    ASSERT_NE(room, 0u);
    if (!std::isnan(gap.floor)) {
      EXPECT_NEAR(column.floor, gap.floor, 0.06);
    }
    if (!std::isnan(gap.ceiling)) {
      EXPECT_NEAR(column.ceiling, gap.ceiling, 0.06);
    }
  }
}

/** A room of 4 m x 3 m, 2.5 m high. */
AirScene
box()
{
  AirScene scene;
  scene.room(0.05, 0.05, 4.05, 3.05, 0.01, 2.51);
  return scene;
}

TEST(RoomAir, IsNoneOfATerraceThatWasSeenThroughADoor)
{
  AirScene scene;
  const AirScene closed = box();
  for (const int i : closed.points.all()) {
    const Eigen::Vector3f& p = closed.points[i];
    if (p.y() < 3.04F || p.x() < 1.5F || p.x() > 2.4F || p.z() < 0.02F || p.z() > 2.1F)
      scene.points.point(p.x(), p.y(), p.z());
  }
  scene.slab(1.5, 3.05, 2.4, 3.15, 2.11); // the head of the door
  scene.slab(0.5, 3.05, 3.5, 5.05, 0.01); // the ground outside
  const Found found(scene);
  ASSERT_EQ(found.building.rooms.size(), 1u);
  EXPECT_NEAR(found.building.rooms[0].area, 12, 1.2);
  for (double y = 3.35; y < 5; y += 0.1)
    EXPECT_EQ(found.roomAt(2, y), 0u) << y;
}

TEST(RoomAir, ReachesASlopeUpToTheWallBesideADuct)
{
  // A ceiling that rises by 0.4 to the wall at 4.05 m, and below it a duct with a slit
  // of 20 cm to the other wall.
  AirScene scene;
  const PlanSlab slope = slabAt(2.41, 0.4);
  scene.slab(0.05, 0.05, 4.05, 3.05, 0.01);
  scene.points.slab(rectangle(0.05, 0.05, 4.05, 3.05), slope);
  scene.sides(0.05, 0.05, 4.05, 3.05, 0.01, 4.01);
  scene.hanging(0.25, 0.05, 0.65, 3.05, 2.11, 2.5);
  const Found found(scene);
  ASSERT_EQ(found.building.rooms.size(), 1u);
  for (const RoomColumn& column : found.building.rooms[0].columns)
    if (const Eigen::Vector2d p = found.building.grid.centre(column.cell);
        p.x() > 1.2 && p.y() > 0.2 && p.y() < 2.9) {
      EXPECT_NEAR(column.ceiling, slope.heightAt(p), 0.11) << p.transpose();
    }
}

TEST(RoomAir, EndsAtACeilingThatWasHiddenAndTellsIt)
{
  AirScene scene;
  scene.slab(0.05, 0.05, 4.05, 3.05, 0.01);
  scene.points.slab(scene.loop(0.05, 0.05, 4.05, 3.05), 2.51,
                    [](double x, double y) { return x < 1 || x > 3 || y > 1.5; });
  scene.sides(0.05, 0.05, 4.05, 3.05, 0.01, 2.51);
  expectGaps("hidden", scene, {{{2, 1, 1}, 0.03, 2.51}, {{2, 2, 1}, 0.03, 2.51}});
  const Found found(scene);
  EXPECT_FALSE(found.gapAt(2, 1, 1).second.ceiling_seen);
  EXPECT_TRUE(found.gapAt(2, 1, 1).second.floor_seen);
  EXPECT_TRUE(found.gapAt(2, 2, 1).second.ceiling_seen);
}

TEST(RoomAir, EndsBelowAWallOfWhichFurnitureHidesTheFoot)
{
  for (const double depth : {0.3, 0.4}) {
    AirScene scene;
    scene.points.slab(scene.loop(0.05, 0.05, 4.05, 3.05), 0.01,
                      [](double x, double) { return x < 1.5 || x > 2.6; });
    scene.slab(0.05, 0.05, 4.05, 3.05, 2.51);
    scene.sides(0.05, 0.05, 4.05, 3.05, 0.01, 2.51);
    scene.wall(2.05, 0.05, 2.05, 3.05, 2.51 - depth, 2.51);
    expectGaps("below the wall", scene,
               {{{2.05, 1.5, 1}, any, 2.51 - depth}, {{1.85, 1.5, 1}, any, 2.51}});
  }
}

using Seen = std::function<bool(double x, double y)>;

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

/** Two rooms above each other, and the scanned parts of their slabs. */
AirScene
storeysWithSlab(const Seen& floor_below, const Seen& floor_above)
{
  AirScene scene;
  const PlanLoop loop = scene.loop(0.05, 0.05, 6.05, 4.05);
  scene.points.slab(loop, 0.01, floor_below);
  scene.slab(0.05, 0.05, 6.05, 4.05, 2.51);
  scene.points.slab(loop, 2.81, floor_above);
  scene.slab(0.05, 0.05, 6.05, 4.05, 5.31);
  scene.sides(0.05, 0.05, 6.05, 4.05, 0.01, 5.31);
  return scene;
}

TEST(RoomAir, StandsOnFloorsThatWereHidden)
{
  expectGaps("in the same place on two storeys", storeysWithSlab(isAside, isAside),
             {{{3, 2, 4}, 2.83, any}, {{3, 2, 1}, 0.03, any}});
  AirScene table = storeysWithSlab(always, isAside);
  table.slab(2.55, 1.55, 3.55, 2.55, 0.76); // no headroom above it
  expectGaps("above a table", table, {{{3, 2, 4}, 2.83, any}});
  AirScene beside = storeysWithSlab(always, always);
  beside.room(8.05, 0.05, 12.05, 4.05, 0.01, 5.31);
  beside.slab(8.05, 0.05, 12.05, 4.05, 2.51);
  const LeftOut unseen = Found(beside).building.left_out.at(0);
  EXPECT_EQ(unseen.reason, "only 0 % of its floor was seen");
  EXPECT_NEAR(unseen.floor, 2.83, 0.06) << "as high as other floors";
  AirScene ribbed = storeysWithSlab(always, isAside);
  for (double y = 0.55; y < 4; y += 0.6)
    ribbed.hanging(0.05, y, 6.05, y + 0.2, 2.21, 2.51);
  expectGaps("above a ribbed ceiling", ribbed,
             {{{3, 1.65, 4}, 2.83, any},
              {{3, 1.95, 4}, 2.83, any},
              {{3, 2.25, 4}, 2.83, any},
              {{3, 2.55, 4}, 2.83, any},
              {{3, 1.85, 1}, any, 2.21}});
}

TEST(RoomAir, GoesOnThroughAVeilUpToTheCeilingButNotThroughTheHeadOfAnOpening)
{
  // Points at 2 m, in every second row and column of those that a surface would have.
  for (const double width : {1.0, 0.5}) {
    AirScene scene = box();
    scene.points.slab(rectangle(1.05, 1.05, 1.05 + width, 2.05), 2.01,
                      [](double x, double y) {
                        return std::lround(x / 0.05 - 0.5) % 2 == 0 &&
                               std::lround(y / 0.05 - 0.5) % 2 == 0;
                      });
    if (width < 1)
      scene.sides(1.05, 1.05, 1.55, 2.05, 2.01, 2.51); // a thick wall above it
    expectGaps("veil", scene, {{{1.3, 1.5, 1}, any, width < 1 ? 2.01 : 2.51}});
  }
}

} // namespace
