// SPDX-License-Identifier: BSD-3-Clause
#include "room_points.h"
#include "sedr_segmentation/src/plan/room_shares.h"

#include <gtest/gtest.h>

namespace {

using namespace pcl::sedr;
using sedr_test::joined;
using sedr_test::rectangle;
using sedr_test::RoomPoints;
using sedr_test::slabAt;

TEST(RoomShares, ACeilingBesideTwoRoomsIsOfTheOneBesideWhichMostOfItLies)
{
  for (const bool is_first_longer : {false, true}) {
    RoomPoints points;
    const double y = is_first_longer ? 4 : 2; // metres of border; the other has 3
    const auto left = points.slab(rectangle(0, 0, 2, y), slabAt(2.5));
    const auto right = points.slab(rectangle(4, 0, 6, 3), slabAt(2.5));
    const auto between = points.slab(rectangle(2, 0, 4, 4), slabAt(2.5));
    PlanEvidence evidence;
    evidence.all = points.all();
    evidence.ceiling = joined(left, right);
    evidence.room.assign(left.size(), 1);
    evidence.room.resize(left.size() + right.size(), 2);
    evidence.room.resize(points.size(), 0);
    const auto rooms =
        roomEvidence(points.view(), evidence, {1, 2}, RoomFitParameters());
    const auto n = between.size();
    EXPECT_EQ(rooms[0].ceiling.size(), left.size() + (is_first_longer ? n : 0));
    EXPECT_EQ(rooms[1].ceiling.size(), right.size() + (is_first_longer ? 0 : n));
  }
}

TEST(RoomShares, ACeilingGoesOnAtItsHeightPastTheTopsOfWallsAndOverNoStep)
{
  for (const double lower : {0.02, 0.1}) {
    RoomPoints points;
    const auto known = points.slab(rectangle(0, 0, 2, 4), slabAt(2.5));
    const auto wall = points.wall(sedr_test::segment({2.025, 4}, {2.025, 0}), 0, 2.5);
    const auto beyond = points.slab(rectangle(2.05, 0, 4, 4), slabAt(2.5 - lower));
    PlanEvidence evidence;
    evidence.all = points.all();
    evidence.ceiling = known;
    const auto rooms = roomEvidence(points.view(), evidence, {1}, RoomFitParameters());
    std::size_t taken = 0;
    for (const int i : rooms[0].ceiling)
      taken += i >= beyond.front() ? 1 : 0;
    EXPECT_EQ(taken, lower < 0.05 ? beyond.size() : 0) << lower;
  }
}

} // namespace
