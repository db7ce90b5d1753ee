// SPDX-License-Identifier: BSD-3-Clause
#include "compare_plans.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using namespace programs;
using namespace pcl::sedr;
using namespace pcl::sedr::tools;
using namespace sedr_test;

TEST(StructureCompare, TellsNothingOfWhatIsTheSame)
{
  EXPECT_EQ(told(twoRooms(), twoRooms()), Lines{});
  EXPECT_EQ(told(twoRooms(), twoRooms(5.04)), Lines{}) << "within the tolerance";
  for (int k = 0; k < 20; ++k) // one binary fraction more than that, another less
    EXPECT_EQ(told(twoRooms(4 + 0.1 * k), twoRooms(4.05 + 0.1 * k)), Lines{}) << k;
  EXPECT_EQ(told(twoRooms(), twoRooms(5.051)).size(), 1U);
  EXPECT_EQ(told(storeysWith(5, 4), storeysWith(5, 4)), Lines{});
  Floorplan renumbered = twoRooms();
  std::swap(renumbered.rooms[0], renumbered.rooms[1]);
  renumbered.rooms[0].id = 1;
  renumbered.rooms[1].id = 2;
  EXPECT_EQ(told(twoRooms(), renumbered), Lines{});
}

TEST(StructureCompare, APartitionThatMovesIsOneThingAndLongerWallsAreNone)
{
  EXPECT_EQ(told(twoRooms(), twoRooms(5.3)),
            Lines{"moved partition by 0.30 m (x +0.30), 4.5 m: room_1_wall_2, "
                  "room_2_wall_4 -> room_1_wall_2, room_2_wall_4"});
}

TEST(StructureCompare, WallsThatMoveApartOrHaveAShaftBetweenThemAreNoPartition)
{
  const auto rooms = [](double end, double start) {
    return Floorplan{{boxRoomOf(1, 0, 0, end, 4.5), boxRoomOf(2, start, 0, 9, 4.5)}};
  };
  EXPECT_EQ(told(rooms(5, 5.1), rooms(4.7, 5.4)),
            (Lines{"moved wall by 0.30 m (x -0.30), 4.5 m: room_1_wall_2 -> "
                   "room_1_wall_2",
                   "moved wall by 0.30 m (x +0.30), 4.5 m: room_2_wall_4 -> "
                   "room_2_wall_4"}));
  EXPECT_EQ(told(rooms(5, 6), rooms(5.3, 6.3)),
            (Lines{"moved wall by 0.30 m (x +0.30), 4.5 m: room_1_wall_2 -> "
                   "room_1_wall_2",
                   "moved wall by 0.30 m (x +0.30), 4.5 m: room_2_wall_4 -> "
                   "room_2_wall_4"}));
}

TEST(StructureCompare, APartitionThatIsTakenOutOrPutIn)
{
  const Floorplan one{{boxRoomOf(1, 0, 0, 9, 4.5)}};
  EXPECT_EQ(told(twoRooms(), one),
            Lines{"vanished partition, 4.5 m: room_1_wall_2, room_2_wall_4"});
  EXPECT_EQ(told(one, twoRooms()),
            Lines{"appeared partition, 4.5 m: room_1_wall_2, room_2_wall_4"});
}

TEST(StructureCompare, ANewPilasterIsOneThing)
{
  Floorplan after = twoRooms();
  auto& walls = after.rooms[0].boundary.elements;
  const std::vector<Eigen::Vector2d> corners{{2, 4.5}, {2, 4}, {1.5, 4}, {1.5, 4.5}};
  PlanElement rest = walls[2];
  rest.start = corners[3];
  walls[2].end = corners[0];
  for (std::size_t k = 0; k + 1 < corners.size(); ++k) {
    PlanElement side;
    side.start = corners[k];
    side.end = corners[k + 1];
    walls.insert(walls.begin() + 3 + static_cast<std::ptrdiff_t>(k), side);
  }
  walls.insert(walls.begin() + 6, rest);
  EXPECT_EQ(
      told(twoRooms(), after),
      Lines{"appeared walls, 1.5 m: room_1_wall_4, room_1_wall_5, room_1_wall_6"});
  std::rotate(walls.begin(), walls.begin() + 4, walls.end());
  EXPECT_EQ(told(twoRooms(), after),
            Lines{"appeared walls, 1.5 m: room_1_wall_1, room_1_wall_2, room_1_wall_8"})
      << "the last wall is beside the first";
}

TEST(StructureCompare, AWholeRoomIsToldWithoutItsWalls)
{
  Floorplan one = twoRooms();
  one.rooms.pop_back();
  EXPECT_EQ(told(twoRooms(), one), Lines{"vanished room, 17.55 m2: room_2"});
  EXPECT_EQ(told(one, twoRooms()), Lines{"appeared room, 17.55 m2: room_2"});
}

TEST(StructureCompare, Columns)
{
  Floorplan with = twoRooms();
  with.rooms[1].columns.push_back(columnLoop(7, 2, 7.5, 2.4));
  EXPECT_EQ(told(twoRooms(), with), Lines{"appeared column, 0.20 m2: room_2_column_1"});
  EXPECT_EQ(told(with, twoRooms()), Lines{"vanished column, 0.20 m2: room_2_column_1"});
  Floorplan moved = twoRooms();
  moved.rooms[1].columns.push_back(columnLoop(7.2, 1.9, 7.7, 2.3));
  EXPECT_EQ(told(with, moved),
            Lines{"moved column by 0.22 m (x +0.20, y -0.10), 0.20 m2: room_2_column_1 "
                  "-> room_2_column_1"});
  Floorplan grown = twoRooms();
  grown.rooms[1].columns.push_back(columnLoop(6.98, 1.98, 7.52, 2.42));
  EXPECT_EQ(told(with, grown), Lines{}) << "at its place";
}

TEST(StructureCompare, DetailsOfCeilingAndFloor)
{
  Floorplan with = twoRooms();
  with.rooms[0].details.push_back({rectangle(0, 3.7, 5, 4.5), {}, slabAt(2.4)});
  EXPECT_EQ(told(with, twoRooms()), Lines{"vanished soffit, 4.00 m2: room_1_detail_1"});
  EXPECT_EQ(told(twoRooms(), with), Lines{"appeared soffit, 4.00 m2: room_1_detail_1"});
  Floorplan lower = with;
  lower.rooms[0].details[0].slab = slabAt(2.25);
  EXPECT_EQ(told(with, lower),
            Lines{"moved soffit by 0.15 m (z -0.15), 4.00 m2: room_1_detail_1 -> "
                  "room_1_detail_1"});
  Floorplan partly = with; // 40 % of the soffit
  partly.rooms[0].details.push_back({rectangle(0, 3.7, 2, 4.5), {}, slabAt(2.1)});
  EXPECT_EQ(told(with, partly), Lines{"appeared soffit, 1.60 m2: room_1_detail_2"});
  Floorplan aside = twoRooms();
  aside.rooms[0].details.push_back({rectangle(0, 2.9, 5, 3.7), {}, slabAt(2.4)});
  EXPECT_EQ(told(with, aside),
            Lines{"moved soffit by 0.80 m (y -0.80), 4.00 m2: room_1_detail_1 -> "
                  "room_1_detail_1"});
  Floorplan step = twoRooms();
  step.rooms[1].floor_details.push_back({rectangle(7, 0, 9, 4.5), {}, slabAt(0.3)});
  EXPECT_EQ(told(twoRooms(), step),
            Lines{"appeared step, 9.00 m2: room_2_floor_detail_1"});
  Floorplan higher = twoRooms();
  higher.rooms[1].ceiling = slabAt(3);
  EXPECT_EQ(told(twoRooms(), higher),
            Lines{"moved ceiling by 0.20 m (z +0.20), 17.55 m2: room_2_ceiling -> "
                  "room_2_ceiling"});
}

TEST(StoreysCompare, AWallOfTheOtherStoreyIsNoAnswer)
{
  EXPECT_EQ(told(storeysWith(5, 4), storeysWith(4, 4)),
            Lines{"moved partition by 1.00 m (x -1.00), 4.5 m: room_1_wall_2, "
                  "room_2_wall_4 -> room_1_wall_2, room_2_wall_4"});
  const Floorplan one{{boxRoomOf(1, 0, 0, 9, 4.5)}};
  Floorplan before = storeysWith(5, 4);
  before.rooms.erase(before.rooms.begin(), before.rooms.begin() + 2);
  before.rooms.push_back(one.rooms[0]); // no partition below the upper one
  EXPECT_EQ(told(before, storeysWith(4, 4)),
            Lines{"appeared partition, 4.5 m: room_1_wall_2, room_2_wall_4"});
}

TEST(StoreysCompare, ARoomIsNotReplacedByOneThatLiesAboveIt)
{
  Floorplan upper = storeysWith();
  upper.rooms.erase(upper.rooms.begin());
  EXPECT_EQ(told(storeysWith(), upper), Lines{"vanished room, 22.50 m2: room_1"});
  upper = storeysWith();
  upper.rooms.erase(upper.rooms.begin() + 2);
  EXPECT_EQ(told(storeysWith(), upper), Lines{"vanished room, 22.50 m2: room_3"});
}

TEST(StoreysCompare, ARoomIsComparedWithTheOneThatSharesMostOfItsHeight)
{
  const auto with_upper_floor = [](double height) {
    Floorplan plan{{boxRoomOf(1, 0, 0, 5, 4.5), boxRoomOf(2, 0, 0, 5, 4.5)}};
    plan.rooms[0].details.push_back({rectangle(0, 3.7, 5, 4.5), {}, slabAt(2.4)});
    plan.rooms[1].floor = slabAt(height);
    plan.rooms[1].ceiling = slabAt(6);
    return plan;
  };
  EXPECT_EQ(told(with_upper_floor(2.9), with_upper_floor(1.9)),
            Lines{"moved floor by 1.00 m (z -1.00), 22.50 m2: room_2_floor -> "
                  "room_2_floor"})
      << "nothing of the room below, into which the upper one reaches";
}

PlanOpening
doorAt(double y)
{
  return {OpeningKind::Door, {1, 2}, {}, {5.05, y}, {5.05, y + 0.9}, 0, 2, 0, 0.1};
}

TEST(StructureCompare, ADoorThatIsBrickedUpAndOneThatIsCut)
{
  Floorplan before = twoRooms();
  before.openings = {doorAt(0.5), doorAt(3)};
  Floorplan after = twoRooms();
  after.openings = {doorAt(1.8), doorAt(3.1)};
  EXPECT_EQ(told(before, after), (Lines{"bricked up door, 1.80 m2: opening_1",
                                        "cut door, 1.80 m2: opening_1"}));
  EXPECT_EQ(told(moved(before, 0, {7, 8, 9}), moved(before, 0, {7, 8, 9})), Lines{});
}

TEST(StructureCompare, ADoorMovesWithItsWall)
{
  Floorplan before = twoRooms();
  before.openings = {doorAt(0.5)};
  Floorplan after{{boxRoomOf(1, 0, 0, 5.6, 4.5), boxRoomOf(2, 5.7, 0, 9, 4.5)}};
  after.openings = {doorAt(0.5)};
  after.openings[0].start.x() = after.openings[0].end.x() = 5.65;
  const Lines changes = told(before, after);
  ASSERT_EQ(changes.size(), 1U);
  EXPECT_EQ(changes[0].rfind("moved partition by 0.60 m", 0), 0U) << changes[0];
}

TEST(StructureCompare, OpeningsOfWallsThatAreGoneOrThatNobodyLookedForAreNoChanges)
{
  Floorplan before = twoRooms();
  before.openings = {doorAt(0.5), doorAt(3)};
  EXPECT_EQ(told(before, twoRooms()), Lines{}) << "nobody looked for openings";
  Floorplan one{{boxRoomOf(1, 0, 0, 9, 4.5)}};
  one.openings = {doorAt(3)};
  one.openings[0].start.x() = one.openings[0].end.x() = 9;
  EXPECT_EQ(told(before, one),
            (Lines{"vanished partition, 4.5 m: room_1_wall_2, room_2_wall_4",
                   "cut door, 1.80 m2: opening_1"}));
}

} // namespace
