// SPDX-License-Identifier: BSD-3-Clause
#include "plan_loops.h"

#include "sedr_filters/src/plan/room_lookup.h"

#include <gtest/gtest.h>

#include <random>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;
using Eigen::Vector2d;

PlanElement
arc(const Vector2d& start, const Vector2d& end, const Vector2d& centre)
{
  PlanElement e;
  e.start = start;
  e.end = end;
  e.centre = centre;
  e.radius = (start - centre).norm();
  return e;
}

PlanDetail
detailOf(const PlanLoop& boundary, double height)
{
  PlanDetail detail;
  detail.boundary = boundary;
  detail.slab.plane[3] = -height;
  return detail;
}

/** A hall of 20 m x 10 m with a round end, a round column, beams, some of which cross,
 * a coffer inside another, a platform and a niche. */
PlanRoom
hall()
{
  PlanRoom room = roomOf(rectangle(0, 0, 20, 10), 4, 3);
  room.boundary.elements[1] = arc({20, 0}, {20, 10}, {20, 5});
  room.columns.push_back(reversed({{arc({7.3, 5}, {7.3, 5}, {7, 5})}}));
  for (int k = 0; k < 12; ++k)
    room.details.push_back(
        detailOf(rectangle(1 + 1.5 * k, 0.2, 1.4 + 1.5 * k, 9.8), 3.5 - 0.01 * k));
  room.details.push_back(detailOf(rectangle(0.2, 4, 19.8, 4.5), 3.3));
  room.details.push_back(detailOf(rectangle(3, 4.1, 4, 4.4), 3.6));
  room.floor_details.push_back(detailOf(rectangle(12, 1, 16, 3), 0.3));
  PlanNiche niche;
  niche.boundary = rectangle(5, -0.4, 7, 0);
  niche.bottom.plane[3] = -1;
  niche.top.plane[3] = -2;
  room.niches.push_back(niche);
  return room;
}

/** Returns random places in and around a hall, many on round numbers and edges. */
std::vector<Vector2d>
places()
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> x(-2, 27);
  std::uniform_real_distribution<double> y(-2, 12);
  std::vector<Vector2d> all;
  for (int k = 0; k < 5000; ++k) {
    Vector2d p(x(random), y(random));
    if (k % 2)
      p = (p * 10).array().round() / 10;
    all.push_back(p);
  }
  return all;
}

TEST(RoomLookup, AnswersAsTheRoomDoes)
{
  const PlanRoom room = hall();
  const RoomLookup lookup(room);
  int inside = 0;
  for (const Vector2d& p : places()) {
    EXPECT_EQ(lookup.contains(p), room.contains(p)) << p.transpose();
    EXPECT_EQ(lookup.isWithinBoundary(p), room.boundary.contains(p)) << p.transpose();
    EXPECT_EQ(lookup.detailAt(p), room.detailAt(p)) << p.transpose();
    EXPECT_EQ(lookup.floorDetailAt(p), room.floorDetailAt(p)) << p.transpose();
    EXPECT_EQ(lookup.nicheAt(p), room.nicheAt(p)) << p.transpose();
    EXPECT_EQ(lookup.ceilingAt(p), room.ceilingAt(p)) << p.transpose();
    EXPECT_EQ(lookup.floorAt(p), room.floorAt(p)) << p.transpose();
    inside += lookup.contains(p) ? 1 : 0;
  }
  EXPECT_GT(inside, 2000);
}

} // namespace
