// SPDX-License-Identifier: BSD-3-Clause
#include "building_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** A hall of 12 m x 8 m, seen from (3, 4) but for the directions between two angles in
 * degrees, from the face of a pier at x = 6 on. */
AirScene
shadowedHall(double degrees, double first, double last)
{
  AirScene scene(degrees);
  const Eigen::Rotation2Dd back(-degrees * M_PI / 180);
  const auto isSeen = [&](const Eigen::Vector2d& p) {
    const double angle = std::atan2(p.y() - 4, p.x() - 3) * 180 / M_PI;
    return p.x() < 6 || angle < first || angle > last;
  };
  for (const double z : {0.01, 3.01})
    scene.points.slab(scene.loop(0.05, 0.05, 12.05, 8.05), z, [&](double x, double y) {
      return isSeen(back * Eigen::Vector2d(x, y));
    });
  for (const PlanElement& e : scene.loop(0.05, 0.05, 12.05, 8.05).elements)
    scene.points.wall(e, 0.01, 3.01,
                      [&](double s, double) { return isSeen(back * e.pointAt(s)); });
  const auto at = [&](double angle) { return 4 + 3 * std::tan(angle * M_PI / 180); };
  scene.wall(6.05, at(first), 6.05, at(last), 0.01, 3.01);
  return scene;
}

double
areaOf(const Building& building)
{
  return building.rooms.empty() ? 0 : building.rooms[0].area;
}

TEST(CloseRooms, AWallGoesOnThroughTheShadowOfAPier)
{
  for (const double degrees : {0.0, 30.0}) {
    SCOPED_TRACE(degrees);
    const AirScene scene = shadowedHall(degrees, -9, 11);
    const Found found(scene);
    ASSERT_EQ(found.building.rooms.size(), 1u);
    EXPECT_NEAR(areaOf(found.building), 96, 2.5);
    EXPECT_NEAR(found.building.rooms[0].inferred, 12.7, 1.5);
    EXPECT_EQ(found.roomAt(11.5, 4), 1u);
    EXPECT_EQ(found.roomAt(12.5, 4), 0u) << "behind the wall";
  }
}

TEST(CloseRooms, TwoWallsGoOnUntilTheyMeetInAHiddenCorner)
{
  for (const double degrees : {0.0, 30.0}) {
    SCOPED_TRACE(degrees);
    const AirScene scene = shadowedHall(degrees, 15, 33);
    const Found found(scene);
    ASSERT_EQ(found.building.rooms.size(), 1u);
    EXPECT_NEAR(areaOf(found.building), 96, 2.5);
    EXPECT_GT(found.building.rooms[0].inferred, 4);
    EXPECT_NEAR(found.building.seen_area,
                areaOf(found.building) - found.building.rooms[0].inferred, 0.1);
    EXPECT_EQ(found.roomAt(11.6, 7.6), 1u) << "in the corner";
    EXPECT_EQ(found.roomAt(11.6, 8.5), 0u);
    EXPECT_EQ(found.roomAt(12.5, 7.6), 0u);
  }
}

TEST(CloseRooms, TellsWhatOfARoomNobodySaw)
{
  // From (12, 6.4) to the corner and back to (9.2, 8).
  for (const double degrees : {0.0, 30.0, 45.0}) {
    SCOPED_TRACE(degrees);
    const AirScene scene = shadowedHall(degrees, 15, 33);
    const Found found(scene);
    ASSERT_EQ(found.building.rooms.size(), 1u);
    EXPECT_NEAR(found.building.rooms[0].unseen_outline, 4.4, 0.3);
  }
  const AirScene seen = flat(30);
  const Found whole(seen);
  for (const BuildingRoom& room : whole.building.rooms) {
    EXPECT_EQ(room.inferred, 0);
    EXPECT_LT(room.unseen_outline, 0.3);
  }
}

/** Two halls of 6 m x 8 m with a wall between them of which nothing was seen but its
 * lower and upper 2 m: either may take what lies between. */
TEST(CloseRooms, TwoRoomsDoNotTakeTheSameCell)
{
  AirScene scene;
  const auto isSeen = [](double x, double y) {
    return std::abs(x - 6) > 1 || std::abs(y - 4) > 2;
  };
  for (const double z : {0.01, 2.51})
    scene.points.slab(scene.loop(0.05, 0.05, 12.05, 8.05), z, isSeen);
  for (const auto& e : scene.loop(0.05, 0.05, 12.05, 8.05).elements)
    scene.points.wall(e, 0.01, 2.51);
  for (const double x : {6.05, 6.15}) {
    scene.wall(x, 0.05, x, 2.05, 0.01, 2.51);
    scene.wall(x, 6.05, x, 8.05, 0.01, 2.51);
  }
  const Found found(scene);
  std::set<CellKey> taken;
  for (const BuildingRoom& room : found.building.rooms)
    for (const RoomColumn& c : room.columns)
      EXPECT_TRUE(taken.insert(keyOf(c.cell)).second);
  ASSERT_EQ(found.building.rooms.size(), 2u);
  EXPECT_GE(found.building.rooms[0].area, found.building.rooms[1].area);
}

/** A hall of 8 m x 6 m and 6 m high, half of it below a gallery that a balustrade ends:
 * before it is no floor of its own. */
TEST(CloseRooms, AnUpperStoreyDoesNotGrowOverAVoid)
{
  AirScene scene;
  scene.room(0.05, 0.05, 8.05, 6.05, 0.01, 5.51);
  scene.slab(4.05, 0.05, 8.05, 6.05, 2.51);
  scene.slab(4.05, 0.05, 8.05, 6.05, 2.81);
  scene.wall(4.05, 0.05, 4.05, 6.05, 2.51, 3.81);
  const Found found(scene);
  ASSERT_EQ(found.building.storeys.size(), 2u);
  EXPECT_NE(found.roomAt(6, 3, 4), 0u);
  EXPECT_NE(found.roomAt(2, 3, 4), found.roomAt(6, 3, 4));
  for (const BuildingRoom& room : found.building.rooms)
    EXPECT_EQ(room.inferred, 0);
}

TEST(CloseRooms, WhatAnOpenDoorLeadsToIsNotMadeUp)
{
  AirScene scene;
  scene.room(0.05, 0.05, 8.05, 5.05, 0.01, 2.51);
  // A room that nobody entered; its walls are the faces of those around it.
  AirScene with_door;
  for (const double z : {0.01, 2.51})
    with_door.slab(0.05, 0.05, 8.05, 5.05, z);
  with_door.wall(0.05, 0.05, 0.05, 5.05, 0.01, 2.51);
  with_door.wall(0.05, 0.05, 8.05, 0.05, 0.01, 2.51);
  with_door.wall(8.05, 0.05, 8.05, 5.05, 0.01, 2.51);
  with_door.wall(0.05, 5.05, 3.05, 5.05, 0.01, 2.51);
  with_door.wall(4.05, 5.05, 8.05, 5.05, 0.01, 2.51);
  with_door.wall(2.05, 5.15, 2.05, 8.05, 0.01, 2.51);
  with_door.wall(2.05, 8.05, 5.05, 8.05, 0.01, 2.51);
  with_door.wall(5.05, 5.15, 5.05, 8.05, 0.01, 2.51);
  const Found found(with_door);
  ASSERT_EQ(found.building.rooms.size(), 1u);
  EXPECT_NEAR(areaOf(found.building), areaOf(Found(scene).building), 0.3);
  EXPECT_EQ(found.roomAt(3.5, 7), 0u);
}

} // namespace
