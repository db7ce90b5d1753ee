// SPDX-License-Identifier: BSD-3-Clause
#include "room_points.h"

#include <pcl/sedr_segmentation/niche_fit.h>

#include <gtest/gtest.h>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** 5 m x 4 m, 2.6 m high, with the recess of the wall x = 5 that is asked for. */
PlanRoom
recessed(double from, double to, double low, double high, double depth)
{
  PlanRoom room = roomOf(rectangle(0, 0, 5, 4), 2.6);
  room.niches = {{rectangle(5, from, 5 + depth, to), slabAt(low), slabAt(high)}};
  return room;
}

/** What fitNiches() finds when the room is known but for its niches. */
std::vector<PlanNiche>
nichesOf(const RoomPoints& points, PlanRoom room, double noise = 0)
{
  room.niches.clear();
  for (auto& element : room.boundary.elements)
    element.residual = noise;
  return fitNiches(points.view(), points.all(), room);
}

void
expectNiche(const PlanNiche& found, const PlanNiche& truth, double tolerance)
{
  EXPECT_NEAR(found.boundary.area(), truth.boundary.area(), 4 * tolerance);
  for (const auto& e : truth.boundary.elements)
    EXPECT_LT(found.boundary.distance(e.start), 2 * tolerance) << e.start.transpose();
  EXPECT_NEAR(found.bottom.heightAt({5, 2}), truth.bottom.heightAt({5, 2}), tolerance);
  EXPECT_NEAR(found.top.heightAt({5, 2}), truth.top.heightAt({5, 2}), tolerance);
}

TEST(Niches, AreFoundWhereTheyAre)
{
  const PlanRoom room = recessed(1, 2.2, 0.9, 2.1, 0.3);
  RoomPoints points(0.03);
  points.room(room);
  const auto niches = nichesOf(points, room);
  ASSERT_EQ(niches.size(), 1u);
  expectNiche(niches[0], room.niches[0], 0.002);
}

TEST(Niches, AreFoundUnderNoise)
{
  const PlanRoom room = recessed(1, 2.2, 0.9, 2.1, 0.3);
  RoomPoints points(0.03, 0.01);
  points.room(room);
  const auto niches = nichesOf(points, room, 0.01);
  ASSERT_EQ(niches.size(), 1u);
  expectNiche(niches[0], room.niches[0], 0.01);
}

TEST(Niches, AreFoundUpToAMetreDeep)
{
  for (const double depth : {0.1, 0.5, 0.7, 0.95}) {
    SCOPED_TRACE(depth);
    const PlanRoom room = recessed(1, 2.6, 0.5, 2.0, depth + 0.01);
    RoomPoints points(0.03);
    points.room(room);
    const auto niches = nichesOf(points, room);
    ASSERT_EQ(niches.size(), 1u);
    expectNiche(niches[0], room.niches[0], 0.002);
  }
}

TEST(Niches, AnotherWingBehindAHiddenWallIsNone)
{
  // Two wings of a U with 0.6 m between them; of the wall of one, nothing was seen.
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

TEST(Niches, OfTwoAboveEachOtherTheLargerIsFound)
{
  // The points of a wall with both: of each room what it has that the other has not.
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

TEST(Niches, AClosedDoorIsNone)
{
  const PlanRoom room = recessed(1, 1.9, 0, 2.05, 0.12);
  RoomPoints points(0.03);
  points.room(room);
  EXPECT_TRUE(nichesOf(points, room).empty());
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
