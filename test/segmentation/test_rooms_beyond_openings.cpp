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

TEST(RoomsBeyondOpenings, ARoomWithAGlassFrontAndADoorThatStandsOpenStays)
{
  // Of the boundary a metre of door, with the room behind it, is apart from the wall.
  RoomAndHall scene;
  scene.plan.rooms[1].boundary = polygon({{4.15, 0},
                                          {6.65, 0},
                                          {6.65, 3},
                                          {4.15, 3},
                                          {4.15, 2},
                                          {4.1, 2},
                                          {4.1, 1},
                                          {4.15, 1}});
  scene.addHall([](const Eigen::Vector3d& p) { return p.x() > 4.14 && p.x() < 6.64; });
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

TEST(RoomsBeyondOpenings, WhatIsOutOfViewIsAFifthOfTheWallsAndAMetreAndAHalfAtLeast)
{
  struct Hall {
    PlanLoop outline;
    bool is_dropped;
  };
  for (const Hall& hall : {Hall{rectangle(4.15, 0, 6.65, 3), true},        // 27 %
                           Hall{rectangle(4.15, 0, 11.15, 3), false},      // 15 %
                           Hall{rectangle(4.15, 0.5, 6.15, 2.5), true}}) { // 2 m
    RoomAndHall scene;
    scene.plan.rooms[1].boundary = hall.outline;
    scene.addHall([](const Eigen::Vector3d& p) { return !isOnDoorWall(p); });
    EXPECT_EQ(scene.drop().size(), hall.is_dropped ? 1u : 0u)
        << hall.outline.area() << " m2";
  }
}

TEST(RoomsBeyondOpenings, WhatIsMoreThanAMetreBeyondTheOpeningIsAnotherMatter)
{
  for (const double gap : {0.7, 1.3}) {
    RoomAndHall scene;
    const double near = 4 + gap;
    scene.plan.rooms[1].boundary = rectangle(near, 0, near + 2.5, 3);
    scene.addHall([&](const Eigen::Vector3d& p) { return p.x() > near + 0.01; });
    EXPECT_EQ(scene.drop().size(), gap < 1 ? 1u : 0u) << gap;
  }
}

TEST(RoomsBeyondOpenings, WhatIsAboveOrBelowIsNotBehind)
{
  for (const double up : {-2.8, 0.0, 2.8}) { // another storey
    RoomAndHall scene;
    scene.plan.rooms[1].floor = slabAt(up);
    scene.plan.rooms[1].ceiling = slabAt(up + 2.5);
    scene.addHall([](const Eigen::Vector3d& p) { return !isOnDoorWall(p); });
    EXPECT_EQ(scene.drop().size(), up == 0 ? 1u : 0u) << up;
  }
}

} // namespace
