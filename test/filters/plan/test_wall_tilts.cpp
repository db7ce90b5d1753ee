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
