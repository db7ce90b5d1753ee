// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_filters/straightening.h>

#include "plan_loops.h"

#include <pcl/sedr_filters/floorplan_io.h>

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

TEST(WallTilts, ARunIsTheTangentOfTheTiltOfTheRoomsOwnWalls)
{
  const WallTilts tilts{{7, 1, ten_degrees}, {8, 2, ten_degrees}, {7, 9, ten_degrees}};
  EXPECT_EQ(wallRuns(raisedRoom(), tilts),
            (std::vector<double>{0, std::tan(ten_degrees), 0, 0}));
  EXPECT_TRUE(isTilted(raisedRoom(), tilts));
  EXPECT_FALSE(isTilted(raisedRoom(), {tilts[1], tilts[2]}));
}

TEST(WallTilts, TheBoundaryOfARoomMovesWithTheHeightAboveItsFloor)
{
  const WallTilts tilts{{7, 1, ten_degrees}}; // the wall at x = 6, into the room
  EXPECT_NEAR(boundaryAt(raisedRoom(), tilts, 1).area(), 24, 1e-9) << "at its foot";
  for (const double up : {0.5, 2.5}) {
    const double x = 6 - up * std::tan(ten_degrees);
    const PlanLoop section = boundaryAt(raisedRoom(), tilts, 1 + up);
    EXPECT_NEAR(section.area(), 4 * x, 1e-9);
    EXPECT_NEAR((section.elements[1].start - Eigen::Vector2d(x, 0)).norm(), 0, 1e-9);
    EXPECT_NEAR((section.elements[2].start - Eigen::Vector2d(x, 4)).norm(), 0, 1e-9);
  }
}

TEST(WallTilts, ARoundWallIsACone)
{
  PlanRoom room = roomOf(circle({3, 3}, 2), 2.5);
  const PlanLoop section = boundaryAt(room, {{1, 0, -ten_degrees}}, 2);
  EXPECT_NEAR(section.elements[0].radius, 2 + 2 * std::tan(ten_degrees), 1e-9);
}

TEST(WallTilts, TheHeadIsTheTopOfTiltedWallsOnly)
{
  PlanRoom room = raisedRoom();
  room.ceiling = slabAt(3.5, 0.1); // 4.1 m at x = 6
  EXPECT_NEAR(headOf(room, {{7, 3, 0.01}}), 3.5, 0.01);
  EXPECT_NEAR(headOf(room, {{7, 1, 0.01}}), 4.1, 0.01);
}

TEST(WallTilts, AreWrittenInDegreesAndRead)
{
  const std::string json = floorplanToJson({{raisedRoom()}});
  EXPECT_EQ(withTilts(json, {}), json);
  const std::string with =
      withTilts(json, {{7, 1, ten_degrees}, {7, 3, -ten_degrees}}, {{7, 55.5}});
  std::string problem;
  const WallTilts read = tiltsFromJson(with, problem);
  EXPECT_EQ(problem, "");
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(read[1].room, 7u);
  EXPECT_EQ(read[1].wall, 3u);
  EXPECT_NEAR(read[1].tilt, -ten_degrees, 1e-15);
  EXPECT_NE(with.find("\"volume\": 55.5"), std::string::npos) << with;
  EXPECT_EQ(floorplanFromJson(with, problem).rooms.size(), 1u);
  EXPECT_EQ(problem, "");
  EXPECT_TRUE(tiltsFromJson(json, problem).empty());
  EXPECT_TRUE(
      tiltsFromJson(withTilts(json, {{7, 0, 5 * ten_degrees}}), problem).empty());
  EXPECT_NE(problem.find("50"), std::string::npos) << problem;
}

} // namespace
