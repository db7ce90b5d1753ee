// SPDX-License-Identifier: BSD-3-Clause
#include "room_points.h"

#include "sedr_segmentation/src/planes/floor_platforms.h"

#include <gtest/gtest.h>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** 5 m x 4 m, 2.6 m high. */
PlanRoom
hall()
{
  return roomOf(rectangle(0, 0, 5, 4), 2.6);
}

/** Returns the heights of the floor levels, lowest first. */
std::vector<double>
floorsOf(const RoomPoints& points)
{
  const LevelParameters parameters;
  std::vector<Level> levels = findLevels(points.view(), points.all(), parameters);
  classifyLevels(levels, parameters);
  markPlatforms(levels, points.view(), points.all(), parameters);
  std::vector<double> heights;
  for (const auto& level : levels)
    if (level.kind == LevelKind::Floor)
      heights.push_back(level.height);
  return heights;
}

void
expectFloors(const RoomPoints& points, const std::vector<double>& heights)
{
  const std::vector<double> found = floorsOf(points);
  ASSERT_EQ(found.size(), heights.size());
  for (std::size_t i = 0; i < heights.size(); ++i)
    EXPECT_NEAR(found[i], heights[i], 0.005);
}

/** Adds a closed box on the floor. */
void
addBox(RoomPoints& points, const PlanLoop& footprint, double height)
{
  points.slab(footprint, height);
  for (const auto& side : footprint.elements)
    points.wall(side, 0, height);
}

TEST(Platforms, OneAlongAWallIsAFloor)
{
  PlanRoom room = hall();
  room.floor_details = {detailOf(rectangle(3.5, 0, 5, 4), 0.3)};
  RoomPoints points;
  points.room(room);
  expectFloors(points, {0, 0.3});
}

TEST(Platforms, ANarrowStepUpToOneIsAFloorToo)
{
  PlanRoom room = hall();
  room.floor_details = {detailOf(rectangle(3.2, 0, 5, 4), 0.15),
                        detailOf(rectangle(3.5, 0, 5, 4), 0.3)};
  RoomPoints points;
  points.room(room);
  expectFloors(points, {0, 0.15, 0.3});
}

TEST(Platforms, ANarrowStepThatLeadsNowhereIsNone)
{
  PlanRoom room = hall();
  room.floor_details = {detailOf(rectangle(4.7, 0, 5, 4), 0.3)}; // a bench
  RoomPoints points;
  points.room(room);
  expectFloors(points, {0});
}

TEST(Platforms, RowsOfSeatsStandOnEachOther)
{
  PlanRoom room = roomOf(rectangle(0, 0, 9, 6), 3.2);
  for (int row = 1; row <= 4; ++row)
    room.floor_details.push_back(
        detailOf(rectangle(3 + 1.2 * row, 0, 4.2 + 1.2 * row, 6), 0.2 * row));
  RoomPoints points;
  points.room(room);
  expectFloors(points, {0, 0.2, 0.4, 0.6, 0.8});
}

TEST(Platforms, StairsAreFloorsTreadByTread)
{
  PlanRoom room = roomOf(rectangle(0, 0, 5, 5), 2.6);
  for (int tread = 1; tread <= 3; ++tread)
    room.floor_details.push_back(
        detailOf(rectangle(2.2 + 0.3 * tread, 0, 5, 5), 0.17 * tread));
  RoomPoints points;
  points.room(room);
  expectFloors(points, {0, 0.17, 0.34, 0.51});
}

TEST(Platforms, OneInTheMiddleIsAFloorIfLargerThanFurniture)
{
  PlanRoom room = hall();
  room.floor_details = {detailOf(rectangle(1.2, 0.8, 3.7, 3.2), 0.2)};
  RoomPoints points;
  points.room(room);
  expectFloors(points, {0, 0.2});
}

TEST(Platforms, AStepOfATenthOfAMetreIsNoTiltedFloor)
{
  PlanRoom room = hall();
  room.floor_details = {detailOf(rectangle(2.6, 0, 5, 4), 0.1)};
  RoomPoints points(0.05, 0.005);
  points.room(room);
  expectFloors(points, {0, 0.1});
}

TEST(Platforms, WhatStandsOnOneHidesHowItGoesOn)
{
  PlanRoom room = hall();
  room.floor_details = {detailOf(rectangle(2.7, 0, 5, 4), 0.3)};
  RoomPoints points; // a desk as long as the platform, nothing seen behind it
  points.room(room,
              [](const Eigen::Vector3d& p) { return p.x() < 4.3 || p.z() > 1.1; });
  RoomPoints seen;
  for (const int i : points.all())
    if (const auto p = points[i]; p.x() < 4.3 || p.z() > 1.1)
      seen.point(p.x(), p.y(), p.z());
  seen.wall(segment({4.3, 4}, {4.3, 0}), 0.3, 1.1);
  expectFloors(seen, {0, 0.3});
}

TEST(Platforms, AreTheirOwnCellsOnly)
{
  PlanRoom room = hall();
  room.floor_details = {detailOf(rectangle(3.5, 0, 5, 4), 0.3)};
  RoomPoints points;
  points.room(room);
  const auto crate = points.slab(rectangle(1, 1, 1.6, 1.6), 0.3);
  LevelParameters parameters;
  std::vector<Level> levels = findLevels(points.view(), points.all(), parameters);
  classifyLevels(levels, parameters);
  markPlatforms(levels, points.view(), points.all(), parameters);
  collectInliers(levels, points.view(), points.all(), parameters);
  for (const auto& level : levels)
    for (const int i : level.inliers)
      EXPECT_TRUE(level.kind == LevelKind::Other || i < crate.front() ||
                  i > crate.back());
}

TEST(Platforms, ABoxInTheRoomIsNone)
{
  RoomPoints points;
  points.room(hall());
  addBox(points, rectangle(1, 1, 3, 2.2), 0.4);
  expectFloors(points, {0});
}

TEST(Platforms, ATableAlongAWallIsNoneForTheFloorIsSeenBelow)
{
  RoomPoints points;
  points.room(hall());
  points.slab(rectangle(0, 0, 1.5, 3), 0.4);
  expectFloors(points, {0});
}

TEST(Platforms, ABedIsTooHigh)
{
  for (const double height : {0.4, 0.45, 0.55}) {
    PlanRoom room = hall();
    room.floor_details = {detailOf(rectangle(3, 2.4, 5, 4), height)};
    RoomPoints points;
    points.room(room);
    expectFloors(points, {0});
  }
}

TEST(Platforms, AStageThatALittleStepLeadsToIsAFloor)
{
  PlanRoom room = hall();
  room.floor_details = {detailOf(rectangle(3.5, 0, 5, 4), 0.5),
                        detailOf(rectangle(3.1, 1.5, 3.5, 2.5), 0.25)};
  RoomPoints points;
  points.room(room);
  expectFloors(points, {0, 0.5});
}

TEST(Platforms, OneThatAStepLeadsToIsAFloorHoweverHigh)
{
  PlanRoom room = hall();
  room.floor_details = {detailOf(rectangle(3.1, 0, 5, 4), 0.25),
                        detailOf(rectangle(3.5, 0, 5, 4), 0.5)};
  RoomPoints points;
  points.room(room);
  expectFloors(points, {0, 0.25, 0.5});
}

} // namespace
