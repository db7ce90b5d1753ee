// SPDX-License-Identifier: BSD-3-Clause
#include "found_niches.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** A room of 5 m x 4 m, 2.6 m high, with the given recess in the wall x = 5. */
PlanRoom
recessed(double from, double to, double low, double high, double depth)
{
  PlanRoom room = roomOf(rectangle(0, 0, 5, 4), 2.6);
  room.niches = {{rectangle(5, from, 5 + depth, to), slabAt(low), slabAt(high)}};
  return room;
}

/** Expects the niches of a room in its points, and no others. */
void
expectFound(const PlanRoom& room,
            double tolerance,
            double noise = 0,
            double spacing = 0.03)
{
  RoomPoints points(spacing, noise);
  points.room(room);
  const auto niches = nichesOf(points, room);
  ASSERT_EQ(niches.size(), room.niches.size());
  for (std::size_t k = 0; k < niches.size(); ++k) {
    const PlanNiche& found = niches[k];
    const PlanNiche& truth = room.niches[k];
    EXPECT_NEAR(found.boundary.area(), truth.boundary.area(), 4 * tolerance);
    for (const auto& e : truth.boundary.elements)
      EXPECT_LT(found.boundary.distance(e.start), 2 * tolerance) << e.start.transpose();
    EXPECT_NEAR(found.bottom.heightAt({5, 2}), truth.bottom.heightAt({5, 2}),
                tolerance);
    EXPECT_NEAR(found.top.heightAt({5, 2}), truth.top.heightAt({5, 2}), tolerance);
  }
}

/** A room with a partly scanned niche, and pieces of wall in it. */
struct Scene {
  PlanRoom room = recessed(1, 2.4, 0.8, 2.2, 0.3);
  RoomPoints points{0.03};

  explicit Scene(const RoomPoints::InSpace& isSeen) { points.room(room, isSeen); }

  /** Adds a piece of wall at `x`. */
  void wallAt(double x, double from, double to, double low, double high)
  {
    points.wall(segment({x, from}, {x, to}), low, high);
  }

  std::size_t niches() const { return nichesOf(points, room).size(); }
};

std::size_t
nichesFor(const PlanRoom& room)
{
  RoomPoints points(0.03);
  points.room(room);
  return nichesOf(points, room).size();
}

TEST(Niches, AreFoundUnderNoise)
{
  expectFound(recessed(1, 2.2, 0.9, 2.1, 0.3), 0.01, 0.01);
  expectFound(recessed(1, 2.2, 0.9, 2.1, 0.3), 0.015, 0.02, 0.02);
}

TEST(Niches, DepthAndSizeAreThoseOfTheParameters)
{
  EXPECT_EQ(nichesFor(recessed(1, 2.2, 0.9, 2.1, 0.19)), 0u) << "a blind";
  EXPECT_EQ(nichesFor(recessed(1, 2.2, 0.9, 2.1, 0.31)), 1u);
  EXPECT_EQ(nichesFor(recessed(1, 2.2, 0.9, 2.1, 1.06)), 0u) << "a hatch";
  EXPECT_EQ(nichesFor(recessed(1, 1.26, 0.5, 2.1, 0.25)), 0u) << "a slot";
  EXPECT_EQ(nichesFor(recessed(1, 2.2, 0.9, 1.16, 0.25)), 0u) << "a slot";
  EXPECT_EQ(nichesFor(recessed(1, 1.7, 0.9, 1.6, 0.35)), 1u);
}

TEST(Niches, WhatReachesFromFloorToCeilingIsAPartOfTheRoom)
{
  EXPECT_EQ(nichesFor(recessed(1, 2.2, 0.9, 2.5, 0.3)), 1u);
  EXPECT_EQ(nichesFor(recessed(1, 2.2, 0.9, 2.6, 0.3)), 1u);
  EXPECT_EQ(nichesFor(recessed(1, 2.2, 0, 2.1, 0.3)), 1u);
  EXPECT_EQ(nichesFor(recessed(1, 2.2, 0, 2.6, 0.3)), 0u);
}

TEST(Niches, AShallowOneMayBeAClosedDoorOrABlind)
{
  for (const double head : {2.05, 2.1})
    EXPECT_EQ(nichesFor(recessed(1, 1.9, 0, head, 0.12)), 0u) << head;
  EXPECT_EQ(nichesFor(recessed(1, 2.9, 0.4, 2.1, 0.12)), 0u);
}

TEST(Niches, ABackThroughWhichOneSeesOnIsNotClosed)
{
  // A grating: a fifth of the back, away from its rim, is open.
  const auto isOpen = [](const Eigen::Vector3d& p) {
    return p.y() > 1.35 && p.y() < 2.05 && p.z() > 1.2 && p.z() < 1.8;
  };
  Scene scene([&](const Eigen::Vector3d& p) { return p.x() < 5.29 || !isOpen(p); });
  EXPECT_EQ(scene.niches(), 1u) << "a board from which nothing comes back";
  scene.wallAt(5.5, 1.35, 2.05, 1.2, 1.8);
  EXPECT_EQ(scene.niches(), 0u);
  scene.wallAt(5.3, 1.35, 2.05, 1.2, 1.8);
  EXPECT_EQ(scene.niches(), 0u) << "glass in it";
}

TEST(Niches, OfAnLIsARectangle)
{
  // One of its two rectangles: below the part that is missing.
  for (const auto& [from, low] : {std::pair(1.6, 1.4), {2.1, 1.9}}) {
    Scene scene([from = from, low = low](const Eigen::Vector3d& p) {
      return p.x() < 5.01 || p.y() < from || p.z() < low;
    });
    scene.wallAt(5, from, 2.4, low, 2.2);
    const auto found = nichesOf(scene.points, scene.room);
    ASSERT_EQ(found.size(), 1u) << from;
    const PlanElement& mouth = found[0].boundary.elements.back();
    EXPECT_NEAR(mouth.end.y(), 1, 0.02);
    EXPECT_NEAR(mouth.start.y(), 2.4, 0.02);
    EXPECT_NEAR(found[0].bottom.heightAt({5, 2}), 0.8, 0.02);
    EXPECT_NEAR(found[0].top.heightAt({5, 2}), low, 0.06) << "to a cell";
  }
}

TEST(Niches, HeightsCountFromTheFloor)
{
  PlanRoom room = recessed(1, 2.2, -2.1, -0.9, 0.3);
  room.floor = slabAt(-3);
  room.ceiling = slabAt(-0.4);
  expectFound(room, 0.002);
}

TEST(Niches, AWallHasTwo)
{
  PlanRoom room = recessed(0.5, 1.1, 0.9, 2.1, 0.3);
  room.niches.push_back(recessed(2, 3.4, 0.5, 2.1, 0.4).niches[0]);
  expectFound(room, 0.002);
}

} // namespace
