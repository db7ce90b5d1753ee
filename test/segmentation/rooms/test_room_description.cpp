// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/rooms/room_description.h"

#include "segmentation/air/air_scene.h"

#include <gtest/gtest.h>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** Describes all air of a scene as one room. */
BuildingRoom
describe(const AirScene& scene)
{
  const SceneAir air(scene);
  PartedAir all;
  all.room.assign(air.gaps.size(), 0);
  all.rooms = 1;
  return describeRooms(air.gaps, all).at(0);
}

/** Adds a row of `n` profiles. */
void
addColumns(BuildingRoom& room, int n, float floor, float ceiling)
{
  for (int k = 0; k < n; ++k)
    room.columns.push_back({{static_cast<std::int32_t>(room.columns.size()), 0},
                            floor,
                            ceiling,
                            true,
                            true});
}

std::string
reasonOf(const BuildingRoom& room)
{
  return noRoomBecause(room, 0.1, true, BuildingParameters(), PartingParameters())
      .reason;
}

LeftOutKind
kindOf(const BuildingRoom& room)
{
  const Verdict verdict =
      noRoomBecause(room, 0.1, true, BuildingParameters(), PartingParameters());
  EXPECT_FALSE(verdict.isRoom());
  return verdict.kind;
}

TEST(DescribeRooms, TellsWhatWasHidden)
{
  AirScene scene;
  scene.points.slab(scene.loop(0.05, 0.05, 4.05, 3.05), 0.01,
                    [](double x, double y) { return x < 1 || x > 3 || y > 1.5; });
  scene.slab(0.05, 0.05, 4.05, 3.05, 2.51);
  scene.sides(0.05, 0.05, 4.05, 3.05, 0.01, 2.51);
  for (const RoomColumn& column : describe(scene).columns) {
    const bool is_hidden =
        column.cell.x >= 10 && column.cell.x < 30 && column.cell.y < 15;
    EXPECT_EQ(column.floor_seen, !is_hidden) << column.cell.x << ' ' << column.cell.y;
    EXPECT_TRUE(column.ceiling_seen);
  }
}

TEST(DescribeRooms, TheFloorIsTheLowestThatATenthHas)
{
  for (const double platform : {0.3, 0.7}) { // of the room
    AirScene scene;
    const double edge = 0.05 + 4 * (1 - platform);
    scene.room(0.05, 0.05, 4.05, 3.05, 0.01, 2.51);
    scene.slab(edge, 0.05, 4.05, 3.05, 0.41);
    EXPECT_NEAR(describe(scene).floor, 0.01, 0.051) << platform;
  }
  AirScene pit;
  pit.points.slab(pit.loop(0.05, 0.05, 4.05, 3.05), 0.01,
                  [](double x, double y) { return x > 0.8 || y > 0.8; });
  pit.slab(0.05, 0.05, 0.8, 0.8, -0.49);
  pit.slab(0.05, 0.05, 4.05, 3.05, 2.51);
  pit.sides(0.05, 0.05, 4.05, 3.05, -0.49, 2.51);
  EXPECT_NEAR(describe(pit).floor, 0.01, 0.051) << "a twentieth lies lower";
}

TEST(DescribeRooms, TheCeilingIsWhatMostOfItHas)
{
  AirScene scene;
  scene.room(0.05, 0.05, 4.05, 3.05, 0.01, 2.91);
  scene.hanging(0.05, 0.05, 1.5, 3.05, 2.51, 2.91);
  EXPECT_NEAR(describe(scene).ceiling, 2.91, 0.051);
}

TEST(NoRoomBecause, ItIsNowhereHighEnough)
{
  BuildingRoom room;
  room.enclosure = 1;
  addColumns(room, 200, 0, 1.7f);
  addColumns(room, 90, 0, 2);
  EXPECT_NE(reasonOf(room).find("headroom of 1.8 m"), std::string::npos);
  addColumns(room, 20, 0.8f, 2.5f); // above a table, which leaves no height to stand
  EXPECT_EQ(reasonOf(room), "");
}

TEST(NoRoomBecause, MostOfItIsTooLow)
{
  BuildingRoom room;
  room.enclosure = 1;
  addColumns(room, 1000, 0, 0.6f);
  addColumns(room, 300, 0, 2.5f); // where the slab below was not scanned
  EXPECT_NE(reasonOf(room).find("headroom of 1.8 m"), std::string::npos);
}

TEST(NoRoomBecause, ItsCeilingWasHardlySeen)
{
  BuildingRoom room;
  room.enclosure = 1;
  addColumns(room, 400, 0, 2.5);
  for (std::size_t k = 0; k < 330; ++k)
    room.columns[k].ceiling_seen = false;
  EXPECT_EQ(reasonOf(room), "only 18 % of its ceiling was seen");
  EXPECT_EQ(kindOf(room), LeftOutKind::Open);
}

} // namespace
