// SPDX-License-Identifier: BSD-3-Clause
#include "niche_rooms.h"

#include "sedr_segmentation/src/niches/niche_panes.h"

#include <cstddef>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** Returns the number of niches that remain of a plan with one of 1.2 x 1 m, when
 * `share` of the wall points are on its back. */
std::size_t
leftOf(double depth, double share, double spacing = 0.01)
{
  const PlanRoom room = recessed(1.4, 2.6, 0.9, 1.9, depth);
  Floorplan plan;
  plan.rooms = {room};
  RoomPoints points(spacing, 0.005);
  const PlanElement& wall = room.boundary.elements[1];
  points.wall(wall, 0, 2.6, [](double s, double z) {
    return s < 1.4 || s > 2.6 || z < 0.9 || z > 1.9;
  });
  double hits = 0;
  points.wall(room.niches[0].boundary.elements[1], 0.9, 1.9, [&](double, double) {
    hits += share;
    const bool is_hit = hits >= 1;
    hits -= is_hit ? 1 : 0;
    return is_hit;
  });
  const std::size_t taken_out = leaveOutPanes(plan, points.view());
  EXPECT_EQ(taken_out + plan.rooms[0].niches.size(), 1u);
  return plan.rooms[0].niches.size();
}

TEST(NichePanes, WhatAFewRaysComeBackFromIsAPane)
{
  for (const double depth : {0.1, 0.3}) {
    EXPECT_EQ(leftOf(depth, 0.05), 0u) << depth;
    EXPECT_EQ(leftOf(depth, 0.1), 0u) << depth;
  }
}

TEST(NichePanes, ABackOfWhichHalfIsHiddenStays)
{
  for (const double share : {0.5, 1.0})
    EXPECT_EQ(leftOf(0.3, share), 1u) << share;
}

TEST(NichePanes, ADeepNicheStaysAsItsSidesHideItsBack)
{
  EXPECT_EQ(leftOf(0.6, 0.1), 1u);
}

TEST(NichePanes, WhereTheWallWasNotSeenNothingIsTakenOut)
{
  EXPECT_EQ(leftOf(0.1, 0.05, 0.7), 1u);
}

TEST(NichePanes, APlanWithoutNichesOrPointsStays)
{
  Floorplan plan;
  EXPECT_EQ(leaveOutPanes(plan, PointView()), 0u);
  plan.rooms = {recessed(1.4, 2.6, 0.9, 1.9, 0.1)};
  EXPECT_EQ(leaveOutPanes(plan, PointView()), 0u);
  EXPECT_EQ(plan.rooms[0].niches.size(), 1u);
}

} // namespace
