// SPDX-License-Identifier: BSD-3-Clause
#include "shaken_plans.h"

namespace {

using namespace sedr_test;

TEST(AdjustPlan, WhatStandsBeforeAWallIsLeftOut)
{
  // A cupboard 4 cm before a third of the wall up to the ceiling, and boards 2 cm
  // before all of it up to 1.2 m.
  const auto isWall = [](const Vector3d& p) {
    return p.y() > 1e-9 || (p.x() > 1.3 && p.z() > 1.2);
  };
  for (const double noise : {0.001, 0.005}) {
    RoomPoints raw(0.02, noise);
    raw.room(plainRoom(), isWall);
    raw.wall(segment({0, 0.04}, {1.3, 0.04}), 0, 2.6);
    raw.wall(segment({1.3, 0.02}, {4, 0.02}), 0, 1.2);
    Floorplan plan = offPlan(plainRoom(), 0.01);
    adjustPlan(plan, raw.view());
    EXPECT_LT(cornerError(plan.rooms[0].boundary, rectangle(0, 0, 4, 3)), 0.001)
        << noise;
  }
}

TEST(AdjustPlan, RevealsOfOpeningsDoNotMoveTheWall)
{
  // Three windows whose reveals are 20 cm deep.
  const auto isOpen = [](double s, double z) {
    return std::fmod(s, 1.3) > 0.3 && z > 0.9 && z < 2.2;
  };
  RoomPoints raw(0.01, 0.004);
  raw.room(plainRoom(),
           [&](const Vector3d& p) { return p.y() > 1e-9 || !isOpen(p.x(), p.z()); });
  for (const double x : {0.3, 1.6, 2.9})
    for (const double jamb : {x, x + 1}) {
      raw.wall(segment({jamb, 0}, {jamb, -0.2}), 0.9, 2.2);
      for (const double z : {0.9, 2.2})
        raw.slab(rectangle(x, -0.2, x + 1, 0), z);
    }
  Floorplan plan = offPlan(plainRoom(), 0.01);
  adjustPlan(plan, raw.view());
  EXPECT_LT(cornerError(plan.rooms[0].boundary, rectangle(0, 0, 4, 3)), 0.0004);
}

TEST(AdjustPlan, ADarkWallIsNoisierThanTheOthers)
{
  const auto isDark = [](const Vector3d& p) { return p.y() < 1e-9; };
  RoomPoints raw(0.02, 0.002);
  raw.room(plainRoom(), [&](const Vector3d& p) { return !isDark(p); });
  RoomPoints dark(0.02, 0.02);
  dark.wall(segment({0, 0}, {4, 0}), 0, 2.6);
  const auto cloud = raw.cloud();
  *cloud += *dark.cloud();
  Floorplan plan = offPlan(plainRoom(), 0.01);
  adjustPlan(plan, PointView(*cloud));
  EXPECT_LT(cornerError(plan.rooms[0].boundary, rectangle(0, 0, 4, 3)), 0.001);
  EXPECT_NEAR(plan.rooms[0].boundary.elements[0].residual, 0.02, 0.003);
}

TEST(AdjustPlan, SoffitOfAWindowAsWideAsTheWallDoesNotMoveItsLowLintel)
{
  RoomPoints raw(0.01, 0.01);
  raw.room(plainRoom(), [&](const Vector3d& p) {
    return p.y() > 1e-9 || p.z() > 2.5 || p.x() < 0.12 || p.x() > 3.88;
  });
  raw.slab(rectangle(0.12, -0.3, 3.88, 0), 2.5);
  Floorplan plan = offPlan(plainRoom(), 0.01);
  adjustPlan(plan, raw.view());
  EXPECT_LT(cornerError(plan.rooms[0].boundary, rectangle(0, 0, 4, 3)), 0.001);
}

} // namespace
