// SPDX-License-Identifier: BSD-3-Clause
#include "niche_rooms.h"

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

TEST(Niches, AreFoundUpToAMetreDeep)
{
  for (const double depth : {0.2, 0.31, 0.5, 0.7, 0.95}) {
    SCOPED_TRACE(depth);
    expectFound(recessed(1, 2.6, 0.5, 2.0, depth + 0.01), 0.002);
  }
}

TEST(Niches, AreFoundUnderNoise)
{
  expectFound(recessed(1, 2.2, 0.9, 2.1, 0.3), 0.01, 0.01);
  expectFound(recessed(1, 2.2, 0.9, 2.1, 0.3), 0.015, 0.02, 0.02);
}

TEST(Niches, AnotherWingBehindAHiddenWallIsNone)
{
  // Two wings of a U, 0.6 m apart; the wall of one was not scanned.
  PlanRoom room = roomOf(rectangle(0, 0, 5, 4), 2.6);
  room.boundary = polygon(
      {{0, 0}, {5, 0}, {5, 4}, {3.1, 4}, {3.1, 1.5}, {2.5, 1.5}, {2.5, 4}, {0, 4}});
  RoomPoints points(0.03);
  points.room(room, [](const Eigen::Vector3d& p) {
    return std::abs(p.x() - 2.5) > 0.01 || p.y() < 2 || p.y() > 3.5 || p.z() < 0.5 ||
           p.z() > 2;
  });
  EXPECT_TRUE(nichesOf(points, room).empty());
}

TEST(Niches, AnAlcoveStartsAtTheFloor)
{
  const PlanRoom room = recessed(1, 2.2, 0, 2.1, 0.4);
  RoomPoints points(0.03);
  points.room(room);
  const auto niches = nichesOf(points, room);
  ASSERT_EQ(niches.size(), 1u);
  EXPECT_NEAR(niches[0].bottom.heightAt({5, 2}), 0, 1e-9);
}

TEST(Niches, ABottomSeenADecimetreAboveTheFloorIsWhereItIs)
{
  expectFound(recessed(1, 2.2, 0.1, 1.2, 0.4), 0.01, 0.005);
}

TEST(Niches, TheHeadOfOneThatReachesTheCeilingIsTheCeiling)
{
  PlanRoom room = recessed(1, 2.2, 0.9, 2.6, 0.4);
  room.ceiling = slabAt(2.6, 0.01, 0);
  RoomPoints points(0.03);
  points.room(room);
  const auto niches = nichesOf(points, room);
  ASSERT_EQ(niches.size(), 1u);
  EXPECT_NEAR(niches[0].top.heightAt({5.4, 2}), room.ceiling.heightAt({5.4, 2}), 1e-9);
}

TEST(Niches, OfTwoAboveEachOtherTheLargerIsFound)
{
  // The points of a wall with both niches: of each room those where the other has none.
  const PlanRoom large = recessed(1, 2.2, 0.5, 1.4, 0.3);
  const PlanRoom small = recessed(1.4, 2.4, 1.6, 2.1, 0.2);
  RoomPoints of_large(0.03);
  of_large.room(large);
  RoomPoints of_small(0.03);
  of_small.room(small);
  RoomPoints points(0.03);
  for (const auto* seen : {&of_large, &of_small})
    for (const int i : seen->all()) {
      const Eigen::Vector3d p = (*seen)[i].cast<double>();
      const bool is_high = p.z() > 1.5;
      if (is_high == (seen == &of_small))
        points.point(p.x(), p.y(), p.z());
    }
  const auto niches = nichesOf(points, large);
  ASSERT_EQ(niches.size(), 1u);
  expectNiche(niches[0], large.niches[0], 0.002);
}

TEST(Niches, AWindowIsNoneThoughItsPaneWasHit)
{
  const PlanRoom room = recessed(1, 2.2, 0.9, 2.1, 0.3);
  RoomPoints points(0.03);
  points.room(room, [](const Eigen::Vector3d& p) { return p.x() < 5.29; });
  points.wall(segment({5.15, 1}, {5.15, 2.2}), 0.9, 2.1); // in the middle of the reveal
  EXPECT_TRUE(nichesOf(points, room).empty());
}

TEST(Niches, AnOpenDoorIsNone)
{
  const PlanRoom room = recessed(1, 1.9, 0, 2.05, 0.3);
  RoomPoints points(0.03);
  points.room(room, [](const Eigen::Vector3d& p) { return p.x() < 5.29; });
  EXPECT_TRUE(nichesOf(points, room).empty());
}

TEST(Niches, AWallBehindFurnitureHasNone)
{
  const PlanRoom room = roomOf(rectangle(0, 0, 5, 4), 2.6);
  RoomPoints points(0.03);
  points.room(room, [](const Eigen::Vector3d& p) {
    return !(p.x() > 4.99 && p.y() > 1 && p.y() < 2.2 && p.z() < 2);
  });
  EXPECT_TRUE(nichesOf(points, room).empty());
}

TEST(Niches, OfNothingAreNone)
{
  const RoomPoints points;
  EXPECT_TRUE(nichesOf(points, roomOf(rectangle(0, 0, 5, 4), 2.6)).empty());
}

} // namespace
