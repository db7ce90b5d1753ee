// SPDX-License-Identifier: BSD-3-Clause
#include "refit_plans.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;
using Eigen::Vector2d;
using Eigen::Vector3d;

TEST(RefitToRaw, ANoiseFreeRoomIsMetExactly)
{
  RoomPoints raw(0.02);
  raw.room(plainRoom());
  Floorplan plan = offPlan();
  const RefitReport report = refitToRaw(plan, raw.view());
  EXPECT_EQ(report.curves, 4u);
  EXPECT_EQ(report.slabs, 2u);
  EXPECT_LT(cornerError(plan.rooms[0].boundary, rectangle(0, 0, 4, 3)), 1e-5);
  for (const Vector2d& p : {Vector2d(0, 0), Vector2d(4, 0), Vector2d(4, 3)}) {
    EXPECT_NEAR(plan.rooms[0].floor.heightAt(p), 0, 1e-5);
    EXPECT_NEAR(plan.rooms[0].ceiling.heightAt(p), 2.6, 1e-5);
  }
}

TEST(RefitToRaw, NoiseIsAveragedAwayAndTold)
{
  // 20,000 points per wall: the deviation is 0.15 mm at its middle, 0.3 mm at its ends.
  for (const double noise : {0.001, 0.01, 0.02}) {
    RoomPoints raw(0.015, noise);
    raw.room(plainRoom());
    Floorplan plan = offPlan();
    refitToRaw(plan, raw.view());
    const double bar = 4 * (2 * noise / std::sqrt(16000.0)) + 0.0001;
    EXPECT_LT(cornerError(plan.rooms[0].boundary, rectangle(0, 0, 4, 3)), bar) << noise;
    EXPECT_NEAR(plan.rooms[0].floor.heightAt({2, 1.5}), 0, bar);
    for (const auto& e : plan.rooms[0].boundary.elements) {
      EXPECT_NEAR(e.residual, noise, 0.1 * noise);
      EXPECT_GT(e.inliers, 10000u);
    }
  }
}

TEST(RefitToRaw, WhatStandsBeforeAWallIsLeftOut)
{
  // A cupboard 4 cm in front of a third of the wall, up to the ceiling.
  const PlanRoom truth = plainRoom();
  const auto isHidden = [](const Vector3d& p) { return p.y() < 1e-9 && p.x() < 1.3; };
  for (const double noise : {0.001, 0.01}) {
    RoomPoints raw(0.015, noise);
    raw.room(truth, [&](const Vector3d& p) { return !isHidden(p); });
    raw.wall(segment({0, 0.04}, {1.3, 0.04}), 0, 2.6);
    Floorplan plan = offPlan();
    refitToRaw(plan, raw.view());
    EXPECT_LT(cornerError(plan.rooms[0].boundary, rectangle(0, 0, 4, 3)), 0.001)
        << noise;
  }
}

TEST(RefitToRaw, FurnitureInTheLowerHalfDoesNotCount)
{
  RoomPoints raw(0.02);
  raw.room(plainRoom(), [](const Vector3d& p) { return p.y() > 0.1 || p.z() > 1.2; });
  raw.wall(segment({0, 0.03}, {4, 0.03}), 0, 1.2);
  Floorplan plan = offPlan();
  refitToRaw(plan, raw.view());
  EXPECT_LT(cornerError(plan.rooms[0].boundary, rectangle(0, 0, 4, 3)), 1e-5);
}

TEST(RefitToRaw, ASurfaceThatWouldMoveFartherThanItsNoiseExplainsStays)
{
  // All points of a wall are 5 cm away from an element with a residual of 2 mm.
  RoomPoints raw(0.02);
  raw.room(roomOf(rectangle(0, -0.05, 4, 3), 2.6));
  Floorplan plan;
  plan.rooms.push_back(plainRoom());
  setSeen(plan.rooms[0].boundary, 0.002);
  const RefitReport report = refitToRaw(plan, raw.view());
  EXPECT_EQ(report.curves, 3u);
  EXPECT_LT(cornerError(plan.rooms[0].boundary, rectangle(0, 0, 4, 3)), 1e-5);

  // A residual of 5 cm makes that plausible.
  setSeen(plan.rooms[0].boundary, 0.05);
  EXPECT_EQ(refitToRaw(plan, raw.view()).curves, 4u);
  EXPECT_LT(cornerError(plan.rooms[0].boundary, rectangle(0, -0.05, 4, 3)), 1e-4);
}

TEST(RefitToRaw, TiltedSlabsTilt)
{
  PlanRoom truth = plainRoom();
  truth.ceiling = slabAt(2.597, 0.002, -0.001);
  truth.floor = slabAt(-0.003, 0, 0.002);
  RoomPoints raw(0.02, 0.005);
  raw.room(truth);
  Floorplan plan = offPlan(0, 2.6);
  refitToRaw(plan, raw.view());
  for (const Vector2d& p : {Vector2d(0, 0), Vector2d(4, 0), Vector2d(4, 3)}) {
    EXPECT_NEAR(plan.rooms[0].ceiling.heightAt(p), truth.ceiling.heightAt(p), 0.0004);
    EXPECT_NEAR(plan.rooms[0].floor.heightAt(p), truth.floor.heightAt(p), 0.0004);
  }
}

TEST(RefitToRaw, TheSlabsOfANicheAreNotTiltedHoweverItIsTurned)
{
  // Noise spreads the points of its back and of the wall in front over both slabs.
  for (const auto& [depth, tolerance] :
       {std::pair(0.15, 0.004), std::pair(0.25, 0.003)})
    for (const double degrees : {0.0, 45.0}) {
      const auto turned = [&](const PlanLoop& loop) {
        return placed(loop, degrees, {1, 2});
      };
      const PlanLoop mouth = turned(rectangle(4, 1, 4 + depth, 2.5));
      PlanRoom truth = roomOf(turned(rectangle(0, 0, 4, 3)), 2.6);
      truth.floor = slabAt(0, 0, 0.001);
      truth.ceiling = slabAt(2.6, 0, 0.001);
      truth.niches = {{mouth, slabAt(0.5), slabAt(1.5)}};
      RoomPoints raw(0.02, 0.02);
      raw.room(truth);
      Floorplan plan;
      plan.rooms = {truth};
      plan.rooms[0].niches = {{mouth, slabAt(0.505), slabAt(1.495)}};
      refitToRaw(plan, raw.view());
      const PlanNiche& niche = plan.rooms[0].niches[0];
      const Eigen::Vector2d middle =
          (mouth.elements[0].start + mouth.elements[2].start) / 2;
      EXPECT_LT(niche.bottom.plane.head<2>().norm(), 1e-12) << depth << ' ' << degrees;
      EXPECT_LT(niche.top.plane.head<2>().norm(), 1e-12) << depth << ' ' << degrees;
      EXPECT_NEAR(niche.bottom.heightAt(middle), 0.5, tolerance)
          << depth << ' ' << degrees;
      EXPECT_NEAR(niche.top.heightAt(middle), 1.5, tolerance)
          << depth << ' ' << degrees;
    }
}

TEST(RefitToRaw, ADetailParallelToItsCeilingStaysSo)
{
  PlanRoom truth = plainRoom();
  truth.ceiling = slabAt(2.597, 0.002, 0);
  PlanDetail soffit = detailOf(rectangle(0, 0, 1, 3), 2.3);
  soffit.slab = slabAt(2.3, 0.002, 0);
  truth.details.push_back(soffit);
  RoomPoints raw(0.02);
  raw.room(truth);
  Floorplan plan = offPlan(0, 2.6);
  plan.rooms[0].details.push_back(detailOf(rectangle(0, 0, 1.004, 3), 2.304));
  setSeen(plan.rooms[0].details[0].boundary, 0.01);
  refitToRaw(plan, raw.view());
  const PlanRoom& room = plan.rooms[0];
  EXPECT_LT((room.details[0].slab.plane - room.ceiling.plane).head<3>().norm(), 1e-12);
  EXPECT_NEAR(room.details[0].slab.heightAt({0.5, 1.5}), 2.301, 1e-4);
  EXPECT_NEAR(room.details[0].boundary.elements[1].start.x(), 1, 1e-4); // its riser
}

TEST(RefitToRaw, TheCircleOfASmallColumnIsUnbiased)
{
  // Scanned from one side only; means of voxels would be 1 mm outside.
  PlanRoom truth = plainRoom();
  PlanLoop column = circle({2, 1.5}, 0.2);
  column.elements[0].counter_clockwise = false; // the room is outside
  truth.columns.push_back(column);
  for (const double noise : {0.0, 0.005}) {
    RoomPoints raw(0.01, noise);
    raw.room(truth, [](const Vector3d& p) {
      return (p.head<2>() - Vector2d(2, 1.5)).norm() > 0.3 || p.x() + p.y() < 3.45;
    });
    Floorplan plan = offPlan();
    PlanLoop found = circle({2.004, 1.497}, 0.206);
    found.elements[0].counter_clockwise = false;
    setSeen(found, 0.01);
    plan.rooms[0].columns.push_back(found);
    refitToRaw(plan, raw.view());
    const PlanElement& e = plan.rooms[0].columns[0].elements[0];
    const double bar = noise > 0 ? 0.0006 : 1e-5;
    EXPECT_LT((e.centre - Vector2d(2, 1.5)).norm(), 2 * bar);
    EXPECT_NEAR(e.radius, 0.2, bar);
  }
}

TEST(RefitToRaw, ALongFlatArcIsJudgedByWhatItMovesNotByItsCentre)
{
  // An arc of 8 m with a radius of 7: 5 mm at its ends move its centre by 5 cm.
  const double half = std::asin(4.0 / 7) * 180 / M_PI;
  const double sagitta = 7 - std::sqrt(33.0);
  const auto hall = [&](double ends) {
    const double radius = (16 + std::pow(sagitta + ends, 2)) / (2 * (sagitta + ends));
    const double angle = std::asin(4 / radius) * 180 / M_PI;
    PlanLoop loop;
    loop.elements = {
        segment({0, 0}, {8, 0}), segment({8, 0}, {8, 5}),
        arc({4, 5 + std::sqrt(radius * radius - 16)}, radius, 270 + angle, 270 - angle),
        segment({0, 5}, {0, 0})};
    for (std::size_t i : {1, 2, 3}) // to the precision of the written corners
      loop.elements[i].start = loop.elements[i - 1].end;
    return loop;
  };
  ASSERT_NEAR(hall(0).elements[2].radius, 7, 1e-9);
  ASSERT_GT(half, 30);
  RoomPoints raw(0.03);
  raw.room(roomOf(hall(0), 3));
  Floorplan plan;
  plan.rooms.push_back(roomOf(hall(0.012), 3));
  ASSERT_GT(std::abs(plan.rooms[0].boundary.elements[2].radius - 7), 0.02);
  setSeen(plan.rooms[0].boundary, 0.003);
  EXPECT_EQ(refitToRaw(plan, raw.view()).curves, 4u);
  const PlanElement& e = plan.rooms[0].boundary.elements[2];
  EXPECT_NEAR(e.radius, 7, 0.002);
  EXPECT_LT((e.start - Vector2d(8, 5)).norm(), 0.001);
}

TEST(RefitToRaw, SmoothJointsStaySmooth)
{
  RoomPoints raw(0.02, 0.005);
  raw.room(roomOf(stadium(4, 1.5), 2.6));
  Floorplan plan;
  plan.rooms.push_back(roomOf(placed(stadium(4, 1.505), 0, {0.003, -0.002}), 2.6));
  setSeen(plan.rooms[0].boundary, 0.01);
  refitToRaw(plan, raw.view());
  const auto& elements = plan.rooms[0].boundary.elements;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const PlanElement& next = elements[(i + 1) % elements.size()];
    EXPECT_GT(elements[i].normalAt(elements[i].length()).dot(next.normalAt(0)),
              1 - 1e-8);
    if (elements[i].isArc()) {
      EXPECT_NEAR(elements[i].radius, 1.5, 0.001);
    }
  }
}

TEST(RefitToRaw, AJointThatIsSmoothInTheScanBecomesSo)
{
  // Fitted with an arc 2 cm larger that meets its walls at 3 degrees, 23 cm away.
  const auto hall = [](const Vector2d& centre, double angle) {
    const double radius = (8 - centre.x()) / std::cos(angle);
    const double degrees = angle * 180 / M_PI;
    PlanLoop loop;
    loop.elements = {segment({0, 0}, {8, 0}), segment({8, 0}, {8, 2}),
                     arc(centre, radius, degrees, 90 - degrees),
                     segment({3, 7}, {0, 7}), segment({0, 7}, {0, 0})};
    loop.elements[1].end = loop.elements[2].start;
    loop.elements[3].start = loop.elements[2].end;
    return loop;
  };
  RoomPoints raw(0.03, 0.005);
  raw.room(roomOf(hall({3, 2}, 0), 2.8));
  Floorplan plan;
  plan.rooms.push_back(roomOf(hall({2.98, 1.98}, 0.05), 2.8));
  setSeen(plan.rooms[0].boundary, 0.01);
  ASSERT_GT((plan.rooms[0].boundary.elements[2].start - Vector2d(8, 2)).norm(), 0.2);
  EXPECT_EQ(refitToRaw(plan, raw.view()).curves, 5u);
  const PlanElement& e = plan.rooms[0].boundary.elements[2];
  EXPECT_NEAR(e.radius, 5, 0.003);
  EXPECT_LT((e.start - Vector2d(8, 2)).norm(), 0.01);
  EXPECT_LT((e.end - Vector2d(3, 7)).norm(), 0.01);
}

} // namespace
