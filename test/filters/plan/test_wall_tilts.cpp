// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_filters/src/walls/tilted_walls.h"

#include "plan_loops.h"

#include <pcl/sedr_filters/floorplan_io.h>
#include <pcl/sedr_filters/plan_measures.h>

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

constexpr double ten_degrees = 10 * M_PI / 180;

/** A room of 6 m x 4 m, 2.5 m high, with its floor at 1 m. */
PlanRoom
raisedRoom()
{
  PlanRoom room = roomOf(rectangle(0, 0, 6, 4), 3.5, 7);
  room.floor = slabAt(1);
  return room;
}

PlanRoom
tilted(PlanRoom room, std::size_t wall, double tilt)
{
  room.boundary.elements[wall].tilt = tilt;
  return room;
}

TEST(WallTilts, AWallEndsWhereItMeetsThoseBesideItAtThatHeight)
{
  PlanRoom room = roomOf(polygon({{0, 0}, {6, 0}, {4, 2}, {0, 2}}), 2.5);
  EXPECT_FALSE(isTilted(room));
  room = tilted(tilted(room, 1, ten_degrees), 2, -ten_degrees); // y = 2, out of it
  EXPECT_TRUE(isTilted(room));
  EXPECT_FALSE(isTilted(withVerticalWalls(room)));
  const double z = 1.5;
  const double shift = z * std::tan(ten_degrees);
  const double x = 6 - std::sqrt(2) * shift; // of the slanted wall at y = 0
  const PlanElement wall = wallAt(room, 1, z);
  EXPECT_NEAR((wall.start - Eigen::Vector2d(x, 0)).norm(), 0, 1e-9);
  EXPECT_NEAR((wall.end - Eigen::Vector2d(x - 2 - shift, 2 + shift)).norm(), 0, 1e-9);
  EXPECT_NEAR(tiltReach(room), 2.5 * std::tan(ten_degrees), 1e-9);
  EXPECT_NEAR(outermostBoundary(room).area(),
              boundaryAt(tilted(room, 1, 0), 2.5).area(), 1e-9);
}

TEST(WallTilts, TheBoundaryOfARoomMovesWithTheHeightAboveItsFloor)
{
  const PlanRoom room = tilted(raisedRoom(), 1, ten_degrees); // x = 6, into the room
  EXPECT_NEAR(boundaryAt(room, 1).area(), 24, 1e-9) << "at its foot";
  for (const double up : {0.5, 2.5}) {
    const double x = 6 - up * std::tan(ten_degrees);
    const PlanLoop section = boundaryAt(room, 1 + up);
    EXPECT_NEAR(section.area(), 4 * x, 1e-9);
    EXPECT_NEAR((section.elements[1].start - Eigen::Vector2d(x, 0)).norm(), 0, 1e-9);
    EXPECT_NEAR((section.elements[2].start - Eigen::Vector2d(x, 4)).norm(), 0, 1e-9);
  }
}

TEST(WallTilts, ARoundWallIsACone)
{
  const PlanRoom room = tilted(roomOf(circle({3, 3}, 2), 2.5), 0, -ten_degrees);
  EXPECT_NEAR(boundaryAt(room, 2).elements[0].radius, 2 + 2 * std::tan(ten_degrees),
              1e-9);
}

TEST(WallTilts, TheHeadIsTheTopOfTiltedWallsOnly)
{
  PlanRoom room = raisedRoom();
  room.ceiling = slabAt(3.5, 0.1); // 4.1 m at x = 6
  EXPECT_NEAR(headOf(tilted(room, 3, 0.01)), 3.5, 0.01);
  EXPECT_NEAR(headOf(tilted(room, 1, 0.01)), 4.1, 0.01);
}

TEST(WallTilts, TakeTheirPartOfTheVolume)
{
  const double run = std::tan(ten_degrees);
  const double volume = 4 * (6 - run * 2.5 / 2) * 2.5;
  EXPECT_NEAR(volumeOf(tilted(raisedRoom(), 1, ten_degrees), 2.5), volume,
              0.005 * volume);
}

TEST(WallTilts, TakeNothingOfAPitsVolume)
{
  PlanRoom room = tilted(raisedRoom(), 1, ten_degrees); // floor at 1, ceiling at 3.5
  room.floor_details = {detailOf(rectangle(1, 1, 3, 3), 0.2)};
  const double volume = 4 * (6 - std::tan(ten_degrees) * 2.5 / 2) * 2.5 + 2 * 2 * 0.8;
  EXPECT_NEAR(volumeOf(room, 2.5), volume, 0.01 * volume);
}

TEST(WallTilts, AreWrittenInDegreesAndRead)
{
  const PlanRoom room = tilted(tilted(raisedRoom(), 1, ten_degrees), 3, -ten_degrees);
  const std::string json = floorplanToJson({{room}});
  std::string problem;
  const Floorplan read = floorplanFromJson(json, problem);
  EXPECT_EQ(problem, "");
  ASSERT_EQ(read.rooms.size(), 1u);
  EXPECT_NEAR(read.rooms[0].boundary.elements[3].tilt, -ten_degrees, 1e-15);
  EXPECT_EQ(read.rooms[0].boundary.elements[0].tilt, 0);
  EXPECT_EQ(floorplanToJson({{raisedRoom()}}).find("tilt"), std::string::npos);
  floorplanFromJson(floorplanToJson({{tilted(room, 0, 5 * ten_degrees)}}), problem);
  EXPECT_NE(problem.find("50"), std::string::npos) << problem;
}

} // namespace
