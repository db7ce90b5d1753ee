// SPDX-License-Identifier: BSD-3-Clause
#include "building_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

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
    EXPECT_EQ(found.roomAt(11.6, 7.6), 1u) << "in the corner";
    EXPECT_EQ(found.roomAt(11.6, 8.5), 0u);
    EXPECT_EQ(found.roomAt(12.5, 7.6), 0u);
  }
}

TEST(CloseRooms, TellsWhatOfARoomNobodySaw)
{
  const AirScene scene = shadowedHall(0, 15, 33);
  const Found found(scene);
  ASSERT_EQ(found.building.rooms.size(), 1u);
  // From (12, 6.4) to the corner and back to (9.2, 8).
  EXPECT_NEAR(found.building.rooms[0].unseen_outline, 4.4, 1.3);
  const Found whole(flat(30));
  for (const BuildingRoom& room : whole.building.rooms) {
    EXPECT_EQ(room.inferred, 0);
    EXPECT_LT(room.unseen_outline, 0.3);
  }
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
