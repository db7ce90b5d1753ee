// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/figures/room_match.h"
#include "plan_loops.h"
#include "simulator/sample_rooms.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace pcl::sedr::benchmark;
namespace sim = pcl::sedr::sim;
using pcl::sedr::Floorplan;
using pcl::sedr::PlanRoom;
using sedr_test::rectangle;
using sedr_test::roomOf;

/** Rooms of 4 x 3 and 2 x 3 m, 2.5 m high, with a partition between them. */
std::vector<sim::RoomTruth>
twoRooms()
{
  sim::Scene scene = sim::test::makeScene(sim::test::makeBoxRoom(4.0, 3.0, 2.5), {}, 1);
  scene.rooms.push_back(scene.rooms.front());
  scene.rooms.back().outline = sim::rectangleLoop({4.1, 0.0}, {6.1, 3.0});
  return sim::roomTruths(scene);
}

TEST(RoomMatch, pairs_rooms_whatever_their_order)
{
  const Floorplan plan{
      {roomOf(rectangle(4.1, 0, 6.1, 3), 2.5), roomOf(rectangle(0, 0, 4, 3), 2.5, 2)}};
  const auto pairs = matchRooms(plan, twoRooms());
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_EQ(pairs[0].found, 1u); // the larger overlap first
  EXPECT_EQ(pairs[0].truth, 0u);
  EXPECT_NEAR(pairs[0].overlap, 12, 1e-6);
  EXPECT_EQ(pairs[1].found, 0u);
  EXPECT_EQ(pairs[1].truth, 1u);
  const RoomFigures figures = measureRooms(plan, twoRooms());
  EXPECT_EQ(figures.rooms_found, 2u);
  EXPECT_EQ(figures.rooms_true, 2u);
  EXPECT_EQ(figures.rooms_matched, 2u);
  EXPECT_NEAR(figures.area_error, 0, 1e-9);
  EXPECT_NEAR(figures.height_error, 0, 1e-9);
  EXPECT_NEAR(figures.volume_error, 0, 1e-9);
  EXPECT_TRUE(std::isnan(figures.mesh_volume_error));
}

TEST(RoomMatch, errors_are_those_of_the_worst_room)
{
  const Floorplan plan{{roomOf(rectangle(0, 0, 4.4, 3), 2.5),        // 10 % too large
                        roomOf(rectangle(4.1, 0, 6.1, 3), 2.4, 2)}}; // 4 % too low
  const RoomFigures figures = measureRooms(plan, twoRooms(), {{1, 30.0}, {2, 14.7}});
  EXPECT_NEAR(figures.area_error, 0.1, 1e-9);
  EXPECT_NEAR(figures.height_error, 0.04, 1e-9);
  EXPECT_NEAR(figures.volume_error, 0.1, 1e-9);
  EXPECT_NEAR(figures.mesh_volume_error, 0.02, 1e-9); // 14.7 of 15
}

TEST(RoomMatch, two_rooms_found_as_one_leave_one_without)
{
  const Floorplan plan{{roomOf(rectangle(0, 0, 6.1, 3), 2.5)}};
  ASSERT_EQ(matchRooms(plan, twoRooms()).size(), 1u);
  const RoomFigures figures = measureRooms(plan, twoRooms());
  EXPECT_EQ(figures.rooms_matched, 1u); // with the larger, 12 of 18.3 square metres
  EXPECT_NEAR(figures.area_error, 6.3 / 12, 1e-6);
}

TEST(RoomMatch, one_room_found_twice_matches_once)
{
  const Floorplan plan{{roomOf(rectangle(0, 0, 1.5, 3), 2.5),
                        roomOf(rectangle(1.5, 0, 4, 3), 2.5, 2),
                        roomOf(rectangle(4.1, 0, 6.1, 3), 2.5, 3)}};
  const auto pairs = matchRooms(plan, twoRooms());
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_EQ(pairs[0].found, 1u); // the larger part
  EXPECT_EQ(pairs[1].found, 2u);
  const RoomFigures figures = measureRooms(plan, twoRooms());
  EXPECT_EQ(figures.rooms_found, 3u);
  EXPECT_EQ(figures.rooms_matched, 2u);
}

TEST(RoomMatch, a_room_elsewhere_is_no_match)
{
  const Floorplan plan{{roomOf(rectangle(20, 0, 24, 3), 2.5),
                        roomOf(rectangle(3.5, 0, 4.5, 3), 2.5, 2)}};
  const auto pairs = matchRooms(plan, twoRooms());
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(pairs[0].found, 1u);
  EXPECT_EQ(measureRooms(plan, twoRooms()).rooms_matched, 0u); // too little overlap
}

TEST(RoomMatch, columns_are_no_floor)
{
  sim::Room room = sim::test::makeBoxRoom(4.0, 3.0, 2.5);
  room.columns.push_back(sim::rectangleLoop({1.0, 1.0}, {2.0, 2.0}));
  const auto truths = sim::roomTruths(sim::test::makeScene(room, {}, 1));
  const Floorplan plan{{roomOf(rectangle(0, 0, 4, 3), 2.5)}};
  EXPECT_NEAR(matchRooms(plan, truths)[0].overlap, 11, 1e-6);
  EXPECT_NEAR(measureRooms(plan, truths).area_error, 1.0 / 11, 1e-9);
}

TEST(RoomMatch, niches_are_volume_but_no_floor)
{
  PlanRoom room = roomOf(rectangle(0, 0, 4, 3), 2.5);
  room.niches.push_back({rectangle(1, -0.3, 3, 0), sedr_test::slabAt(1),
                         sedr_test::slabAt(2)}); // 0.6 cubic metres
  const RoomFigures figures = measureRooms({{room}}, {twoRooms()[0]});
  EXPECT_NEAR(figures.area_error, 0, 1e-9);
  EXPECT_NEAR(figures.height_error, 0, 1e-9);
  EXPECT_NEAR(figures.volume_error, 0.6 / 30, 1e-9);
}

TEST(RoomMatch, no_rooms_have_no_errors)
{
  const RoomFigures figures = measureRooms(Floorplan(), twoRooms());
  EXPECT_EQ(figures.rooms_found, 0u);
  EXPECT_TRUE(std::isnan(figures.area_error));
}

} // namespace
