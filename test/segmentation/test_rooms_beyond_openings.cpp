// SPDX-License-Identifier: BSD-3-Clause
#include "room_points.h"

#include <pcl/sedr_filters/plan_evidence.h>
#include <pcl/sedr_segmentation/rooms_beyond_openings.h>

#include <gtest/gtest.h>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** A room of 4 m x 3 m, and beyond a wall of 0.15 m and a door from y = 1 to 2 a hall
 * of 2.5 m x 3 m. */
struct RoomAndHall {
  RoomAndHall()
  {
    plan.rooms = {roomOf(rectangle(0, 0, 4, 3), 2.5),
                  roomOf(rectangle(4.15, 0, 6.65, 3), 2.5)};
    plan.rooms[0].id = 1;
    plan.rooms[1].id = 2;
    points.room(plan.rooms[0],
                [](const Eigen::Vector3d& p) { return !(p.x() > 3.99 && isDoor(p)); });
  }

  static bool isDoor(const Eigen::Vector3d& p)
  {
    return p.y() > 1 && p.y() < 2 && p.z() < 2;
  }

  /** The hall, of which `keep` was seen. */
  void addHall(const RoomPoints::InSpace& keep) { points.room(plan.rooms[1], keep); }

  std::vector<std::string> drop()
  {
    measureEvidence(plan, points.view(), points.all());
    return dropRoomsBeyondOpenings(plan, points.view(), points.all());
  }

  Floorplan plan;
  RoomPoints points;
};

bool
isOnDoorWall(const Eigen::Vector3d& p)
{
  return p.x() < 4.16;
}

TEST(RoomsBeyondOpenings,
     TheHallBehindADoorOfWhichTheWallWithTheDoorWasNotSeenIsLeftOut)
{
  RoomAndHall scene;
  scene.addHall([](const Eigen::Vector3d& p) { return !isOnDoorWall(p); });
  const std::vector<std::string> sentences = scene.drop();
  ASSERT_EQ(scene.plan.rooms.size(), 1u);
  EXPECT_EQ(scene.plan.rooms[0].id, 1u);
  EXPECT_EQ(scene.plan.rooms[0].boundary.elements.size(), 4u);
  ASSERT_EQ(sentences.size(), 1u);
  EXPECT_NE(sentences[0].find("room 2: 7.50 m2"), std::string::npos) << sentences[0];
}

TEST(RoomsBeyondOpenings, ARoomOfWhichTheWallWithTheDoorWasSeenStays)
{
  RoomAndHall scene;
  scene.addHall([](const Eigen::Vector3d& p) {
    return !(isOnDoorWall(p) && RoomAndHall::isDoor(p));
  });
  EXPECT_TRUE(scene.drop().empty());
  EXPECT_EQ(scene.plan.rooms.size(), 2u);
}

TEST(RoomsBeyondOpenings, AWallBehindAWardrobeIsHiddenNotOutOfView)
{
  RoomAndHall scene;
  scene.addHall([](const Eigen::Vector3d& p) { return !isOnDoorWall(p); });
  scene.points.wall(segment({4.75, 3}, {4.75, 0}), 0, 2.4); // its front
  EXPECT_TRUE(scene.drop().empty());
  EXPECT_EQ(scene.plan.rooms.size(), 2u);
}

TEST(RoomsBeyondOpenings, ARoomWithAnUnseenWallThatNoOtherRoomIsBehindStays)
{
  RoomAndHall scene;
  scene.addHall([](const Eigen::Vector3d& p) {
    return p.x() < 6.64 && !(isOnDoorWall(p) && RoomAndHall::isDoor(p));
  });
  EXPECT_TRUE(scene.drop().empty());
  EXPECT_EQ(scene.plan.rooms.size(), 2u);
}

TEST(RoomsBeyondOpenings, AClosetWhoseDoorIsAsWideAsItIsStays)
{
  RoomAndHall scene;
  scene.plan.rooms[1].boundary = rectangle(4.15, 0.9, 5.35, 2.1);
  scene.addHall([](const Eigen::Vector3d& p) { return !isOnDoorWall(p); });
  EXPECT_TRUE(scene.drop().empty());
  EXPECT_EQ(scene.plan.rooms.size(), 2u);
}

} // namespace
