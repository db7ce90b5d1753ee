// SPDX-License-Identifier: BSD-3-Clause
#include "room_points.h"

#include "sedr_segmentation/src/niches/ceiling_slits.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace pcl::sedr;
using namespace sedr_test;

namespace {

constexpr double top = 2.5;
constexpr double noise = 0.003;

/** A room of 4 x 3 metres whose outline excludes a wardrobe at its far wall. */
PlanLoop
aroundWardrobe()
{
  return polygon(
      {{0, 0}, {4, 0}, {4, 3}, {2.5, 3}, {2.5, 2.4}, {1, 2.4}, {1, 3}, {0, 3}});
}

/** The room with an object in a corner excluded. */
PlanLoop
aroundCorner()
{
  return polygon({{0, 0}, {4, 0}, {4, 2.4}, {2.5, 2.4}, {2.5, 3}, {0, 3}});
}

/** Points of the ceiling within a loop and of the walls on it; within 0.2 metres of its
 * sides only up to `high`. */
RoomPoints
scanOf(const PlanRoom& room, double high)
{
  RoomPoints points(0.01, noise);
  points.slab(room.boundary, top);
  const auto addWalls = [&](const PlanLoop& loop, bool are_low) {
    for (const PlanElement& e : loop.elements) {
      const Eigen::Vector2d middle = e.pointAt(e.length() / 2);
      const bool is_outer = middle.x() < 0.01 || middle.x() > 3.99 ||
                            middle.y() < 0.01 || middle.y() > 2.99;
      points.wall(e, top - 0.4, is_outer && !are_low ? top : high);
    }
  };
  addWalls(room.boundary, false);
  for (const PlanLoop& column : room.columns)
    addWalls(column, true);
  return points;
}

Floorplan
planOf(const PlanRoom& room)
{
  Floorplan plan;
  plan.rooms.push_back(room);
  return plan;
}

std::size_t
leftOut(Floorplan& plan, double slit)
{
  const RoomPoints points = scanOf(plan.rooms.front(), top - slit);
  return leaveOutBelowSlits(plan, points.view());
}

} // namespace

TEST(CeilingSlits, AWardrobeFiveCentimetresBelowTheCeilingIsNoWall)
{
  Floorplan plan = planOf(roomOf(aroundWardrobe(), top));
  EXPECT_EQ(leftOut(plan, 0.05), 1u);
  const PlanLoop& boundary = plan.rooms.front().boundary;
  EXPECT_EQ(boundary.elements.size(), 4u);
  EXPECT_NEAR(boundary.area(), 12, 1e-9);
}

TEST(CeilingSlits, NorIsOneInACorner)
{
  Floorplan plan = planOf(roomOf(aroundCorner(), top));
  EXPECT_EQ(leftOut(plan, 0.05), 1u);
  const PlanLoop& boundary = plan.rooms.front().boundary;
  EXPECT_EQ(boundary.elements.size(), 4u);
  EXPECT_NEAR(boundary.area(), 12, 1e-9);
}

TEST(CeilingSlits, WhatGoesUpToTheCeilingStays)
{
  for (const PlanLoop& loop : {aroundWardrobe(), aroundCorner()}) {
    Floorplan plan = planOf(roomOf(loop, top));
    EXPECT_EQ(leftOut(plan, 0), 0u);
    EXPECT_EQ(plan.rooms.front().boundary.elements.size(), loop.elements.size());
  }
}

TEST(CeilingSlits, ACabinetBelowTheCeilingIsNoColumn)
{
  for (const double slit : {0.05, 0.0}) {
    PlanRoom room = roomOf(rectangle(0, 0, 4, 3), top);
    room.columns.push_back(polygon({{1, 1}, {1, 1.6}, {2, 1.6}, {2, 1}}));
    Floorplan plan = planOf(room);
    EXPECT_EQ(leftOut(plan, slit), slit > 0 ? 1u : 0u);
    EXPECT_EQ(plan.rooms.front().columns.size(), slit > 0 ? 0u : 1u);
  }
}

TEST(CeilingSlits, AColumnOfWhichFewPointsWereSeenStays)
{
  // Of 90 points down to 25 cm below the ceiling, 18 are expected in the slit.
  struct Seen {
    int in_slit;
    std::size_t columns;
  };
  for (const Seen& seen : {Seen{6, 1}, Seen{1, 0}}) {
    PlanRoom room = roomOf(rectangle(0, 0, 4, 3), top);
    room.columns.push_back(reversed(circle({2, 1.5}, 0.23)));
    Floorplan plan = planOf(room);
    RoomPoints points(0.01, noise);
    points.slab(room.boundary, top);
    const PlanElement& side = room.columns[0].elements[0];
    const auto addPoints = [&](int count, double high, double low) {
      for (int k = 0; k < count; ++k) {
        const double share = (k + 0.5) / count;
        const Eigen::Vector2d p =
            side.pointAt(side.length() * (0.1 + 0.8 * std::fmod(7 * share, 1)));
        points.point(p.x(), p.y(), top - high - (low - high) * share);
      }
    };
    addPoints(90, 0.1, 0.25);
    addPoints(seen.in_slit, 0.016, 0.044);
    leaveOutBelowSlits(plan, points.view());
    EXPECT_EQ(plan.rooms.front().columns.size(), seen.columns) << seen.in_slit;
  }
}

TEST(CeilingSlits, AreNotToldFromNoiseOfTheCeiling)
{
  // With noise of 2 cm: three times that exceeds the slit.
  Floorplan plan = planOf(roomOf(aroundWardrobe(), top));
  RoomPoints points(0.01, 0.02);
  points.slab(plan.rooms.front().boundary, top);
  for (const PlanElement& e : plan.rooms.front().boundary.elements)
    points.wall(e, top - 0.4, top - 0.05);
  EXPECT_EQ(leaveOutBelowSlits(plan, points.view()), 0u);
}

TEST(CeilingSlits, TheSameIsLeftOutForAnyNumberOfThreads)
{
  for (const unsigned threads : {1u, 3u}) {
    Floorplan plan = planOf(roomOf(aroundWardrobe(), top));
    const RoomPoints points = scanOf(plan.rooms.front(), top - 0.05);
    EXPECT_EQ(leaveOutBelowSlits(plan, points.view(), {}, threads), 1u);
  }
}
