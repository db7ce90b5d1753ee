// SPDX-License-Identifier: BSD-3-Clause
#include "room_points.h"
#include "segmented_rooms.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;
using Eigen::Vector3d;

/** An opening up to the ceiling, y from `low` to `high`, in a wall between x = 4 and
 * 4 + thickness. */
struct Opening {
  double low = 0;
  double high = 0;
  double thickness = 0;

  bool isWithin(const Vector3d& p) const
  {
    return p.x() > 3.9 && p.x() < 4.1 + thickness && p.y() > low && p.y() < high;
  }
};

/** A wall of some length with openings, between two rooms of 20 m2, turned by some
 * degrees: both are 2.5 m high, and so are the openings. */
RoomPoints
roomsWith(const std::vector<Opening>& openings,
          double degrees,
          double noise,
          double length = 5)
{
  const double thickness = openings.front().thickness;
  RoomPoints points(0.05, noise);
  const auto turned = [&](const PlanLoop& loop) {
    return placed(loop, degrees, {1, 2});
  };
  const double c = std::cos(degrees * M_PI / 180);
  const double s = std::sin(degrees * M_PI / 180);
  const auto isWall = [&](const Vector3d& p) {
    const Vector3d back(c * (p.x() - 1) + s * (p.y() - 2),
                        -s * (p.x() - 1) + c * (p.y() - 2), p.z());
    for (const Opening& opening : openings)
      if (opening.isWithin(back))
        return false;
    return true;
  };
  const double far = 4 + thickness;
  const double depth = 20 / length;
  points.room(roomOf(turned(rectangle(4 - depth, 0, 4, length)), 2.5), isWall);
  points.room(roomOf(turned(rectangle(far, 0, far + depth, length)), 2.5), isWall);
  for (const Opening& opening : openings) {
    const PlanLoop reveal =
        turned(rectangle(4, opening.low, 4 + thickness, opening.high));
    points.slab(reveal, 0);
    points.slab(reveal, 2.5);
    points.wall(reveal.elements[0], 0, 2.5);
    points.wall(reveal.elements[2], 0, 2.5);
  }
  return points;
}

TEST(RoomPassages, AnOpeningAsHighAsTheRoomsPartsThemBetweenItsJambs)
{
  for (const double degrees : {0.0, 17.0, 45.0})
    for (const double thickness : {0.12, 0.4})
      for (const double width : {0.9, 2.0}) {
        const SegmentedRooms rooms(
            roomsWith({{1.2, 1.2 + width, thickness}}, degrees, 0.005));
        EXPECT_EQ(rooms.regions.size(), 2u)
            << degrees << ' ' << thickness << ' ' << width;
        ASSERT_FALSE(rooms.regions.empty());
        EXPECT_NEAR(rooms.area(0), 20, 1.5) << "up to the wall, not into the passage";
      }
}

TEST(RoomPassages, SoDoTwoOpeningsInOneWall)
{
  const SegmentedRooms rooms(roomsWith({{0.8, 1.9, 0.15}, {3.1, 4.2, 0.15}}, 0, 0.005));
  EXPECT_EQ(rooms.regions.size(), 2u);
  EXPECT_EQ(rooms.at(1 + 4.075, 2 + 1.35), -1) << "within the wall is no room's";
}

TEST(RoomPassages, AWallOfWhichLittleIsLeftJoins)
{
  const SegmentedRooms rooms(roomsWith({{0.4, 4.6, 0.15}}, 0, 0.005));
  EXPECT_EQ(rooms.regions.size(), 1u);
}

TEST(RoomPassages, OneOfMoreThanThreeMetresJoins)
{
  for (const double width : {2.8, 3.4}) {
    const SegmentedRooms rooms(roomsWith({{2.5, 2.5 + width, 0.15}}, 0, 0.005, 8));
    EXPECT_EQ(rooms.regions.size(), width < 3 ? 2u : 1u) << width;
  }
}

TEST(RoomPassages, BesideAWallThatEndsFreelyTheyLeadFromARoomToItself)
{
  // The second opening reaches the outer wall: both sides are one room.
  const SegmentedRooms rooms(roomsWith({{0.8, 1.9, 0.15}, {2.9, 5.1, 0.15}}, 0, 0.005));
  ASSERT_EQ(rooms.regions.size(), 1u);
  EXPECT_EQ(rooms.at(1 + 4.075, 2 + 1.35), 0) << "its ceiling there is the room's";
}

TEST(RoomPassages, TwoCornersThatFaceEachOtherAreNone)
{
  RoomPoints points(0.05, 0.003);
  points.room(roomOf(polygon({{0, 0},
                              {1.6, 0},
                              {1.6, 0.4},
                              {2.4, 0.4},
                              {2.4, 2.8},
                              {0.8, 2.8},
                              {0.8, 1.4},
                              {0, 1.4}}),
                     2.5));
  EXPECT_EQ(SegmentedRooms(points).regions.size(), 1u);
}

TEST(RoomPassages, ARowOfPillarsHasNone)
{
  RoomPoints points(0.05, 0.005);
  PlanRoom hall = roomOf(rectangle(0.01, 0.01, 8.01, 6.01), 2.7);
  for (int k = 0; k < 5; ++k)
    hall.columns.push_back(
        reversed(rectangle(3.81, 0.41 + 1.2 * k, 4.21, 0.81 + 1.2 * k)));
  points.room(hall);
  EXPECT_EQ(SegmentedRooms(points).regions.size(), 1u);
}

/** A room of 5 m x 4 m and, `gap` metres beyond its wall of 10 cm with a door of
 * 0.9 m, the ceiling of a lobby with walls on its far sides: what was seen of it
 * through the door. Its floor was seen up to the wall. In two pieces, 0.3 m of the
 * lobby's ceiling were hidden. */
RoomPoints
roomWithLobby(double gap,
              const std::vector<std::size_t>& sides = {0, 1, 2},
              bool in_pieces = false)
{
  RoomPoints points(0.05, 0.003);
  points.room(roomOf(rectangle(0.01, 0.01, 5.01, 4.01), 2.5), [](const Vector3d& p) {
    return p.x() < 4.9 || p.y() < 1.5 || p.y() > 2.4 || p.z() > 2;
  });
  const double near = 5.11 + gap;
  const PlanLoop lobby = rectangle(near, 0.81, near + 1.8, 3.21);
  points.slab(lobby, 2.3, [&](double, double y) {
    return !in_pieces || std::abs(y - 2.01) > 0.15;
  });
  points.slab(rectangle(5.01, 0.81, near + 1.8, 3.21), 0);
  for (const std::size_t side : sides)
    points.wall(lobby.elements[side], 0, 2.3);
  return points;
}

TEST(SegmentRooms, WhatWasSeenThroughADoorIsNone)
{
  const SegmentedRooms rooms(roomWithLobby(0.6));
  ASSERT_EQ(rooms.regions.size(), 1u);
  EXPECT_EQ(rooms.at(2.5, 2), 0);
}

TEST(SegmentRooms, TwoPiecesOfItDoNotKeepEachOther)
{
  EXPECT_EQ(SegmentedRooms(roomWithLobby(0.6, {0, 1, 2}, true)).regions.size(), 1u);
}

TEST(SegmentRooms, WithACeilingUpToTheWallBetweenItIsOne)
{
  EXPECT_EQ(SegmentedRooms(roomWithLobby(0)).regions.size(), 2u);
}

TEST(SegmentRooms, NextToARoomFewerWallsMakeOne)
{
  for (const double gap : {0.3, 0.6}) { // no wall is thicker than half a metre
    RoomPoints points = roomWithLobby(gap, {1, 2});
    EXPECT_EQ(SegmentedRooms(points).regions.size(), gap < 0.5 ? 2u : 1u) << gap;
  }
}

} // namespace
