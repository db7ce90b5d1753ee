// SPDX-License-Identifier: BSD-3-Clause
#include "plan_loops.h"

#include "sedr_segmentation/src/curves/plan_curves.h"
#include "sedr_segmentation/src/refit/plan_regularisation.h"

#include <gtest/gtest.h>

#include <random>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;
using Eigen::Vector2d;

/** Returns the loop with elements marked as fitted to `per_metre` points per metre. */
PlanLoop
seen(PlanLoop loop, double noise, double per_metre = 400)
{
  for (auto& e : loop.elements) {
    e.inliers = static_cast<std::size_t>(per_metre * e.length());
    e.residual = noise;
  }
  return loop;
}

/** Returns a polygon with each side turned about its middle and the corners recomputed.
 */
PlanLoop
turned(const PlanLoop& polygon_loop, const std::vector<double>& degrees)
{
  Floorplan plan;
  plan.rooms.push_back(roomOf(polygon_loop, 2.5));
  PlanCurves curves(plan);
  for (std::size_t i = 0; i < degrees.size(); ++i) {
    MeasuredCurve& m = curves.curves[i];
    m.curve.point = m.pivot;
    m.curve.direction = Eigen::Rotation2Dd(degrees[i] * M_PI / 180) * m.curve.direction;
  }
  EXPECT_TRUE(curves.rebuild(0.5).empty());
  return plan.rooms[0].boundary;
}

double
angleBetween(const PlanElement& a, const PlanElement& b)
{
  const Vector2d u = (a.end - a.start).normalized();
  const Vector2d v = (b.end - b.start).normalized();
  return std::atan2(std::abs(leftOf(u).dot(v)), std::abs(u.dot(v))) * 180 / M_PI;
}

double
cornerError(const PlanLoop& loop, const PlanLoop& truth)
{
  double worst = 0;
  for (std::size_t i = 0; i < truth.elements.size(); ++i)
    worst = std::max(worst, (loop.elements[i].start - truth.elements[i].start).norm());
  return worst;
}

void
expectClosed(const PlanLoop& loop)
{
  for (std::size_t i = 0; i < loop.elements.size(); ++i) {
    const PlanElement& e = loop.elements[i];
    EXPECT_EQ(e.end, loop.elements[(i + 1) % loop.elements.size()].start);
    if (e.isArc()) {
      EXPECT_NEAR((e.start - e.centre).norm(), e.radius, 1e-8);
      EXPECT_NEAR((e.end - e.centre).norm(), e.radius, 1e-8);
    }
  }
}

TEST(RegularisePlan, WhatIsNearlySquareBecomesSquare)
{
  for (const double tilt : {0.0, 23.0}) {
    const PlanLoop truth =
        placed(polygon({{0, 0}, {5, 0}, {5, 2}, {2, 2}, {2, 4}, {0, 4}}), tilt, {1, 2});
    Floorplan plan;
    plan.rooms.push_back(
        roomOf(seen(turned(truth, {0.03, -0.05, 0.04, -0.06, 0.08, 0.02}), 0.01), 2.5));
    const double before = cornerError(plan.rooms[0].boundary, truth);
    const auto report = regularisePlan(plan);
    const PlanLoop& loop = plan.rooms[0].boundary;
    EXPECT_EQ(report.parallel, 5u);
    for (std::size_t i = 0; i < 6; ++i)
      EXPECT_NEAR(angleBetween(loop.elements[i], loop.elements[(i + 1) % 6]), 90, 1e-7);
    EXPECT_LT(cornerError(loop, truth), before);
    expectClosed(loop);
  }
}

TEST(RegularisePlan, AWallThatIsADegreeOffStays)
{
  for (const double noise : {0.001, 0.02})
    for (const double length : {1.0, 4.0}) {
      SCOPED_TRACE(testing::Message() << noise << " over " << length);
      const PlanLoop truth = rectangle(0, 0, 6, length);
      Floorplan plan;
      plan.rooms.push_back(roomOf(seen(turned(truth, {0, 1, 0, 0}), noise, 2000), 2.5));
      const PlanLoop was = plan.rooms[0].boundary;
      regularisePlan(plan);
      const auto& e = plan.rooms[0].boundary.elements;
      EXPECT_NEAR(angleBetween(e[0], e[1]), 89, 0.02);
      EXPECT_NEAR(angleBetween(e[0], e[3]), 90, 1e-7);
      EXPECT_LT(cornerError(plan.rooms[0].boundary, was), 0.0005);
    }
}

TEST(RegularisePlan, ADegreeIsNothingToAWallThatIsHardlyKnown)
{
  // A side of 30 cm with 12 points at 2 cm noise: its direction has a deviation of 4
  // degrees.
  const PlanLoop truth =
      polygon({{0, 0}, {5, 0}, {5, 3}, {0.3, 3}, {0.3, 2.7}, {0, 2.7}});
  Floorplan plan;
  plan.rooms.push_back(roomOf(seen(turned(truth, {0, 0, 0, 1, 0, 0}), 0.02, 40), 2.5));
  regularisePlan(plan);
  const auto& e = plan.rooms[0].boundary.elements;
  EXPECT_NEAR(angleBetween(e[3], e[2]), 90, 1e-7);
}

TEST(RegularisePlan, TheFacesOfAPartitionAreParallel)
{
  Floorplan plan;
  plan.rooms.push_back(
      roomOf(seen(turned(rectangle(0, 0, 4, 3), {0, 0.04, 0, 0}), 0.01), 2.5));
  plan.rooms.push_back(
      roomOf(seen(turned(rectangle(4.1, 0, 8, 3), {0, 0, 0, -0.05}), 0.01), 2.5, 2));
  regularisePlan(plan);
  EXPECT_NEAR(angleBetween(plan.rooms[0].boundary.elements[1],
                           plan.rooms[1].boundary.elements[3]),
              0, 1e-7);
}

TEST(RegularisePlan, TheEdgesOfADetailStayOnTheWallsThatMove)
{
  const PlanLoop walls = turned(rectangle(0, 0, 5, 4), {0.03, -0.04, 0.05, -0.02});
  const auto& e = walls.elements;
  const auto onWall = [&](std::size_t i, double share) {
    return e[i].pointAt(share * e[i].length());
  };
  // A soffit along the upper wall, between the walls on its left and right.
  PlanLoop soffit = polygon({onWall(3, 0.2), onWall(1, 0.8), e[2].start, e[2].end});
  Floorplan plan;
  plan.rooms.push_back(roomOf(seen(walls, 0.01), 2.5));
  plan.rooms[0].details.push_back(detailOf(seen(soffit, 0.01), 2.2));
  regularisePlan(plan);
  const auto& room = plan.rooms[0];
  for (const std::size_t i : {1u, 2u, 3u})
    for (const Vector2d& p : {room.details[0].boundary.elements[i].start,
                              room.details[0].boundary.elements[i].end})
      EXPECT_LT(room.boundary.distance(p), 1e-9);
  EXPECT_NEAR(angleBetween(room.boundary.elements[0], room.boundary.elements[1]), 90,
              1e-7);
  EXPECT_NEAR(
      angleBetween(room.details[0].boundary.elements[0], room.boundary.elements[0]), 0,
      1e-7);
}

TEST(RegularisePlan, SmoothJointsBecomeTangent)
{
  // The arcs were fitted a little too large or small; the corners are the crossings.
  PlanLoop loop = roundedRectangle(6, 4, 1);
  for (const std::size_t i : {1u, 5u}) {
    PlanElement& arc_element = loop.elements[i];
    arc_element.radius = 1.0006;
    for (const bool at_start : {true, false}) {
      PlanElement& line = loop.elements[at_start ? i - 1 : i + 1];
      const Vector2d foot = at_start ? line.end : line.start;
      const Vector2d along = (line.end - line.start).normalized();
      const double across = (foot - arc_element.centre).norm();
      const double step =
          std::sqrt(arc_element.radius * arc_element.radius - across * across);
      const Vector2d corner = foot + (at_start ? -step : step) * along;
      (at_start ? line.end : line.start) = corner;
      (at_start ? arc_element.start : arc_element.end) = corner;
    }
  }
  Floorplan plan;
  plan.rooms.push_back(roomOf(seen(loop, 0.005), 2.5));
  const auto report = regularisePlan(plan);
  EXPECT_EQ(report.tangent, 8u);
  EXPECT_EQ(report.equal_radius, 3u);
  const auto& elements = plan.rooms[0].boundary.elements;
  expectClosed(plan.rooms[0].boundary);
  for (std::size_t i = 0; i < 8; ++i) {
    const PlanElement& e = elements[i];
    EXPECT_NEAR((e.normalAt(e.length()) - elements[(i + 1) % 8].normalAt(0)).norm(), 0,
                1e-6);
    if (e.isArc()) {
      EXPECT_NEAR(e.radius, 1, 0.0015);
      EXPECT_NEAR(e.radius, elements[1].radius, 1e-9);
      EXPECT_NEAR(std::abs(e.sweep()), M_PI / 2, 1e-6);
    }
  }
}

TEST(RegularisePlan, ACornerThatIsNotSmoothStaysOne)
{
  // An arc of 5 m that meets the side walls at an angle.
  const double half = std::asin(3.0 / 5) * 180 / M_PI;
  const PlanLoop truth{{segment({-3, 0}, {3, 0}), segment({3, 0}, {3, 4}),
                        arc({0, 0}, 5, 90 - half, 90 + half),
                        segment({-3, 4}, {-3, 0})}};
  Floorplan plan;
  plan.rooms.push_back(roomOf(seen(truth, 0.005), 2.5));
  EXPECT_EQ(regularisePlan(plan).tangent, 0u);
  EXPECT_LT(cornerError(plan.rooms[0].boundary, truth), 1e-9);
}

TEST(RegularisePlan, ColumnsOfOneKindHaveOneRadius)
{
  PlanRoom room = roomOf(seen(rectangle(0, 0, 9, 5), 0.005), 2.5);
  const double radii[] = {0.3004, 0.2997, 0.3002, 0.35};
  for (std::size_t i = 0; i < 4; ++i)
    room.columns.push_back(
        seen(reversed(circle({2.0 + static_cast<double>(i), 2.5}, radii[i])), 0.005));
  Floorplan plan;
  plan.rooms.push_back(room);
  EXPECT_EQ(regularisePlan(plan).equal_radius, 2u);
  const auto& columns = plan.rooms[0].columns;
  EXPECT_NEAR(columns[0].elements[0].radius, 0.3001, 1e-5) << "weighted by length";
  EXPECT_NEAR(columns[0].elements[0].radius, columns[1].elements[0].radius, 1e-12);
  EXPECT_NEAR(columns[0].elements[0].radius, columns[2].elements[0].radius, 1e-12);
  EXPECT_NEAR(columns[3].elements[0].radius, 0.35, 1e-9);
  for (const auto& column : columns) {
    EXPECT_EQ(column.elements[0].start, column.elements[0].end);
    EXPECT_LT(column.area(), 0);
  }
}

TEST(RegularisePlan, PartsOfOneWallAreCollinear)
{
  PlanLoop loop = polygon({{0, 0},
                           {2, 0},
                           {2, 0.2},
                           {2.4, 0.2},
                           {2.4, 0.0004},
                           {5, 0.0004},
                           {5, 3},
                           {0, 3}});
  Floorplan plan;
  plan.rooms.push_back(roomOf(seen(loop, 0.005), 2.5));
  EXPECT_EQ(regularisePlan(plan).collinear, 1u);
  const auto& e = plan.rooms[0].boundary.elements;
  EXPECT_NEAR(lineThrough(e[0].start, e[0].end).distance(e[4].start), 0, 1e-9);
  EXPECT_NEAR(lineThrough(e[0].start, e[0].end).distance(e[4].end), 0, 1e-9);
  // Two centimetres apart they are separate walls.
  loop = polygon(
      {{0, 0}, {2, 0}, {2, 0.2}, {2.4, 0.2}, {2.4, 0.02}, {5, 0.02}, {5, 3}, {0, 3}});
  plan.rooms[0] = roomOf(seen(loop, 0.005), 2.5);
  EXPECT_EQ(regularisePlan(plan).collinear, 0u);
  EXPECT_LT(cornerError(plan.rooms[0].boundary, loop), 1e-9);
}

TEST(RegularisePlan, WhatNobodySawFollows)
{
  // Three walls were scanned; the fourth only connects them.
  PlanLoop loop = seen(turned(rectangle(0, 0, 5, 4), {0.02, -0.03, 0.03, 0}), 0.01);
  loop.elements[3].inliers = 0;
  loop.elements[3].residual = 0;
  Floorplan plan;
  plan.rooms.push_back(roomOf(loop, 2.5));
  regularisePlan(plan);
  const auto& e = plan.rooms[0].boundary.elements;
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(angleBetween(e[i], e[(i + 1) % 4]), 90, 1e-7);
  EXPECT_LT(cornerError(plan.rooms[0].boundary, loop), 0.01);
}

TEST(RegularisePlan, NothingIsNothing)
{
  Floorplan plan;
  EXPECT_EQ(regularisePlan(plan).parallel, 0u);
  plan.rooms.push_back(roomOf(rectangle(0, 0, 4, 3), 2.5));
  const PlanLoop was = plan.rooms[0].boundary;
  regularisePlan(plan);
  EXPECT_LT(cornerError(plan.rooms[0].boundary, was), 1e-9) << "nothing was measured";
}

TEST(PlanCurves, SharesWhatIsOnOneLine)
{
  Floorplan plan;
  plan.rooms.push_back(roomOf(rectangle(0, 0, 5, 4), 2.5));
  plan.rooms[0].details.push_back(detailOf(rectangle(0, 3, 5, 4), 2.2));
  plan.rooms.push_back(roomOf(rectangle(0, 4, 5, 8), 2.5, 2));
  const PlanCurves curves(plan);
  ASSERT_EQ(curves.loops.size(), 3u);
  EXPECT_EQ(curves.curves.size(), 9u) << "four walls, one edge, four walls";
  EXPECT_EQ(curves.loops[1].curves[2], curves.loops[0].curves[2]);
  EXPECT_NE(curves.loops[2].curves[0], curves.loops[0].curves[2])
      << "another room's face is another wall";
}

TEST(PlanCurves, RefusesToBreakALoop)
{
  Floorplan plan;
  plan.rooms.push_back(roomOf(
      polygon({{0, 0}, {5, 0}, {5, 4}, {3, 4}, {3, 1}, {2.9, 1}, {2.9, 4}, {0, 4}}),
      2.5));
  const PlanLoop was = plan.rooms[0].boundary;
  PlanCurves curves(plan);
  // One face of the slot passes beyond the other.
  curves.curves[curves.loops[0].curves[3]].curve.point.x() -= 0.15;
  EXPECT_EQ(curves.rebuild(1), std::vector<std::size_t>{0});
  EXPECT_EQ(cornerError(plan.rooms[0].boundary, was), 0);
  PlanCurves again(plan);
  again.curves[again.loops[0].curves[3]].curve.point.x() -= 0.05;
  EXPECT_EQ(again.rebuild(0.02), std::vector<std::size_t>{0}) << "too far";
  EXPECT_TRUE(again.rebuild(0.06).empty());
  EXPECT_NEAR(plan.rooms[0].boundary.elements[3].start.x(), 2.95, 1e-9);
}

} // namespace
