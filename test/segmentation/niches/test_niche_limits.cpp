// SPDX-License-Identifier: BSD-3-Clause
#include "niche_rooms.h"

#include <cmath>
#include <functional>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

using Seen = std::function<bool(const Eigen::Vector3d&)>;

/** A room with a partly scanned niche, and pieces of wall in it. */
struct Scene {
  PlanRoom room = recessed(1, 2.4, 0.8, 2.2, 0.3);
  RoomPoints points{0.03};

  explicit Scene(const Seen& isSeen) { points.room(room, isSeen); }

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

TEST(NicheLimits, DepthAndSizeAreThoseOfTheParameters)
{
  EXPECT_EQ(nichesFor(recessed(1, 2.2, 0.9, 2.1, 0.19)), 0u) << "a blind";
  EXPECT_EQ(nichesFor(recessed(1, 2.2, 0.9, 2.1, 0.21)), 1u);
  EXPECT_EQ(nichesFor(recessed(1, 2.2, 0.9, 2.1, 1.06)), 0u) << "a hatch";
  EXPECT_EQ(nichesFor(recessed(1, 1.26, 0.5, 2.1, 0.25)), 0u) << "a slot";
  EXPECT_EQ(nichesFor(recessed(1, 2.2, 0.9, 1.16, 0.25)), 0u) << "a slot";
  EXPECT_EQ(nichesFor(recessed(1, 1.36, 0.9, 1.26, 0.25)), 1u);
}

TEST(NicheLimits, OneThatIsBuiltAQuarterOfAMetreDeepIsFoundInAnyNoise)
{
  for (unsigned seed = 1; seed <= 8; ++seed) {
    const PlanRoom room = recessed(1, 1.6, 0.5, 1.5, 0.25);
    RoomPoints points(0.03, 0.01, seed);
    points.room(room);
    EXPECT_EQ(nichesOf(points, room, 0.01).size(), 1u) << seed;
  }
}

TEST(NicheLimits, WhatReachesFromFloorToCeilingIsAPartOfTheRoom)
{
  EXPECT_EQ(nichesFor(recessed(1, 2.2, 0.9, 2.5, 0.3)), 1u);
  EXPECT_EQ(nichesFor(recessed(1, 2.2, 0.9, 2.6, 0.3)), 1u);
  EXPECT_EQ(nichesFor(recessed(1, 2.2, 0, 2.1, 0.3)), 1u);
  EXPECT_EQ(nichesFor(recessed(1, 2.2, 0, 2.6, 0.3)), 0u);
}

TEST(NicheLimits, AShallowOneMayBeAClosedDoorOrABlind)
{
  for (const double head : {2.05, 2.1})
    EXPECT_EQ(nichesFor(recessed(1, 1.9, 0, head, 0.12)), 0u) << head;
  EXPECT_EQ(nichesFor(recessed(1, 2.9, 0.4, 2.1, 0.12)), 0u);
}

TEST(NicheLimits, ABackThatThingsHideIsNotClosed)
{
  // Books, 15 cm deep, in front of 45 % of the back in strips of 9 cm.
  const auto isBook = [](double y) { return std::fmod(y, 0.2) < 0.09; };
  Scene scene([&](const Eigen::Vector3d& p) { return p.x() < 5.29 || !isBook(p.y()); });
  for (double y = 1; y < 2.3; y += 0.2)
    scene.wallAt(5.15, y, y + 0.09, 0.82, 2.18);
  EXPECT_EQ(scene.niches(), 0u);
}

TEST(NicheLimits, ABackThroughWhichOneSeesOnIsNotClosed)
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

TEST(NicheLimits, AnLIsNoRectangle)
{
  const auto nichesWithout = [](double from, double low) {
    Scene scene([&](const Eigen::Vector3d& p) {
      return p.x() < 5.01 || p.y() < from || p.z() < low;
    });
    scene.wallAt(5, from, 2.4, low, 2.2);
    return scene.niches();
  };
  EXPECT_EQ(nichesWithout(1.6, 1.4), 0u) << "a third of it is wall";
  EXPECT_EQ(nichesWithout(2.1, 1.9), 1u) << "a twentieth is a lamp";
}

TEST(NicheLimits, HeightsCountFromTheFloor)
{
  PlanRoom room = recessed(1, 2.2, -2.1, -0.9, 0.3);
  room.floor = slabAt(-3);
  room.ceiling = slabAt(-0.4);
  expectFound(room, 0.002);
}

TEST(NicheLimits, ThoseOfAWallComeAlongIt)
{
  PlanRoom room = recessed(0.5, 1.1, 0.9, 2.1, 0.3);
  room.niches.push_back(recessed(2, 3.4, 0.5, 2.1, 0.4).niches[0]);
  expectFound(room, 0.002);
}

} // namespace
