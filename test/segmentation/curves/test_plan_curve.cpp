// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/curves/plan_curve.h"
#include "sedr_segmentation/src/curves/plan_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace {

using namespace pcl::sedr;
using Eigen::Vector2d;
using Points = std::vector<WeightedPoint>;

PlanCurve
circleAt(const Vector2d& centre, double radius)
{
  PlanCurve curve;
  curve.point = centre;
  curve.radius = radius;
  return curve;
}

Vector2d
onCircle(const PlanCurve& circle, double degrees)
{
  const double a = degrees * M_PI / 180;
  return circle.point + circle.radius * Vector2d(std::cos(a), std::sin(a));
}

Points
alongLine(const PlanCurve& line, double from, double to, double off = 0)
{
  Points points;
  const Vector2d across(-line.direction.y(), line.direction.x());
  for (double s = from; s <= to + 1e-9; s += 0.05)
    points.push_back({line.point + s * line.direction + off * across, 1});
  return points;
}

Points
alongCircle(const PlanCurve& circle, double from, double to, double off = 0)
{
  Points points;
  const double step = 0.05 / circle.radius * 180 / M_PI;
  for (double a = from; a <= to + 1e-9; a += step)
    points.push_back({onCircle(circleAt(circle.point, circle.radius + off), a), 1});
  return points;
}

/** Returns the angle between two lines regardless of direction, radians. */
double
angleBetween(const PlanCurve& a, const PlanCurve& b)
{
  return std::asin(std::min(1.0, std::abs(a.direction.x() * b.direction.y() -
                                          a.direction.y() * b.direction.x())));
}

TEST(PlanCurve, ALineIsInfinite)
{
  const PlanCurve line = lineThrough({1, 1}, {4, 5});
  EXPECT_FALSE(line.isCircle());
  EXPECT_NEAR(line.direction.norm(), 1, 1e-12);
  EXPECT_NEAR(line.distance({7, 9}), 0, 1e-12);
  EXPECT_NEAR(line.distance(Vector2d(7, 9) + Vector2d(-0.8, 0.6) * 2), 2, 1e-12);
  EXPECT_TRUE(
      line.project(Vector2d(7, 9) + Vector2d(0.8, -0.6)).isApprox(Vector2d(7, 9)));
  EXPECT_NEAR(std::abs(line.tangentAt({0, 0}).dot(Vector2d(0.6, 0.8))), 1, 1e-12);
}

TEST(PlanCurve, ACircleIsWhole)
{
  const PlanCurve circle = circleAt({2, -1}, 3);
  EXPECT_TRUE(circle.isCircle());
  EXPECT_NEAR(circle.distance({2, -1}), 3, 1e-12);
  EXPECT_NEAR(circle.distance({2, 4}), 2, 1e-12);
  EXPECT_NEAR(circle.distance({2, 1}), 1, 1e-12);
  EXPECT_TRUE(circle.project({2, 7}).isApprox(Vector2d(2, 2)));
  EXPECT_NEAR(circle.distance(circle.project({2, -1})), 0, 1e-12) << "of the centre";
  EXPECT_NEAR(std::abs(circle.tangentAt({2, 7}).x()), 1, 1e-12);
}

TEST(CircleThrough, ThreePointsGivesTheirCircle)
{
  const PlanCurve truth = circleAt({100, -50}, 2.5);
  const PlanCurve circle =
      circleThrough(onCircle(truth, 10), onCircle(truth, 250), onCircle(truth, 100));
  EXPECT_NEAR((circle.point - truth.point).norm(), 0, 1e-9);
  EXPECT_NEAR(circle.radius, truth.radius, 1e-9);
}

TEST(CircleThrough, PointsOnALineGivesTheLine)
{
  const PlanCurve line = circleThrough({0, 0}, {1, 1}, {3, 3});
  EXPECT_FALSE(line.isCircle());
  EXPECT_NEAR(line.distance({2, 2}), 0, 1e-12);
  EXPECT_FALSE(circleThrough({1, 1}, {1, 1}, {1, 1}).isCircle());
}

TEST(FitLine, IsExactInEveryDirection)
{
  for (const double degrees : {0.0, 30.0, 90.0, 91.0, 179.0}) {
    const double a = degrees * M_PI / 180;
    const PlanCurve truth =
        lineThrough({3, 4}, Vector2d(3, 4) + Vector2d(std::cos(a), std::sin(a)));
    const PlanCurve line = fitLine(alongLine(truth, -1, 2));
    EXPECT_NEAR(angleBetween(line, truth), 0, 1e-9) << degrees;
    EXPECT_NEAR(truth.distance(line.point), 0, 1e-9);
    EXPECT_NEAR(line.residual, 0, 1e-9);
    EXPECT_EQ(line.inliers, 61u);
  }
}

TEST(FitLine, WeighsItsPoints)
{
  const PlanCurve axis = lineThrough({0, 0}, {1, 0});
  Points points = alongLine(axis, 0, 2, 0);
  for (auto& p : alongLine(axis, 0, 2, 0.1)) {
    p.weight = 3;
    points.push_back(p);
  }
  const PlanCurve line = fitLine(points);
  EXPECT_NEAR(line.distance({1, 0.075}), 0, 1e-9);
  // A quarter of the weight is 7.5 cm away, the rest 2.5 cm.
  EXPECT_NEAR(line.residual, std::sqrt(0.25 * 0.075 * 0.075 + 0.75 * 0.025 * 0.025),
              1e-9);
}

TEST(FitCircle, IsExactFromARoughStart)
{
  for (const double sweep : {40.0, 90.0, 359.0}) {
    const PlanCurve truth = circleAt({20, -3}, 2);
    const PlanCurve circle =
        fitCircle(alongCircle(truth, 30, 30 + sweep), circleAt({20.2, -3.1}, 1.7));
    EXPECT_NEAR((circle.point - truth.point).norm(), 0, 1e-6) << sweep;
    EXPECT_NEAR(circle.radius, 2, 1e-6) << sweep;
    EXPECT_NEAR(circle.residual, 0, 1e-6);
  }
}

TEST(FitCircle, IsTheMiddleOfTwoRings)
{
  const PlanCurve truth = circleAt({1, 1}, 0.5);
  Points points = alongCircle(truth, 0, 359, 0.01);
  for (const auto& p : alongCircle(truth, 0, 359, -0.01))
    points.push_back(p);
  const PlanCurve circle = fitCircle(points, circleAt({1.1, 1}, 0.4));
  EXPECT_NEAR(circle.radius, 0.5, 1e-4);
  EXPECT_NEAR(circle.residual, 0.01, 1e-4);
}

TEST(FitCircle, ThatCannotConvergeLeavesTheStart)
{
  const PlanCurve start = circleAt({0, 1}, 1);
  const PlanCurve circle =
      fitCircle(alongLine(lineThrough({0, 0}, {1, 0}), -1, 1), start);
  EXPECT_TRUE(circle.point.allFinite());
  EXPECT_GT(circle.radius, 0);
  const Points same(5, {{3, 3}, 1});
  EXPECT_TRUE(fitCircle(same, start).point.allFinite());
}

TEST(FitRobustly, ALineIsNotPulledByTheCupboard)
{
  const PlanCurve wall = lineThrough({0, 0}, {1, 0.2});
  Points points = alongLine(wall, 0, 4);
  for (const auto& p : alongLine(wall, 0, 0.5, 0.04)) // 4 cm off
    points.push_back(p);
  const PlanCurve start = lineThrough({0, 0.02}, {1, 0.21});
  EXPECT_GT(angleBetween(fitLine(points), wall), 0.001) << "else this shows nothing";
  const PlanCurve line = fitRobustly(points, start, 0.05, 0.1, 25);
  EXPECT_NEAR(angleBetween(line, wall), 0, 1e-6);
  EXPECT_NEAR(wall.distance(line.point), 0, 1e-6);
  EXPECT_EQ(line.inliers, 81u);
}

TEST(FitRobustly, ACircleIsNotPulledByWhatStandsBeforeIt)
{
  const PlanCurve wall = circleAt({5, 5}, 3);
  Points points = alongCircle(wall, 0, 120);
  for (const auto& p : alongCircle(wall, 0, 25, -0.04))
    points.push_back(p);
  const PlanCurve circle =
      fitRobustly(points, circleAt({5.01, 5}, 2.99), 0.05, 0.1, 25);
  EXPECT_NEAR(circle.radius, 3, 1e-5);
  EXPECT_NEAR((circle.point - wall.point).norm(), 0, 1e-5);
}

TEST(FitRobustly, RefusesCirclesBeyondTheLimits)
{
  const PlanCurve wall = circleAt({5, 5}, 3);
  const Points points = alongCircle(wall, 0, 120);
  const PlanCurve start = circleAt({5.01, 5}, 2.99);
  EXPECT_EQ(fitRobustly(points, start, 0.05, 3.1, 25).radius, 2.99);
  EXPECT_EQ(fitRobustly(points, start, 0.05, 0.1, 2.95).radius, 2.99);
  EXPECT_NEAR(fitRobustly(points, start, 0.05, 2.95, 3.1).radius, 3, 1e-6);
}

TEST(FitRobustly, LeavesTheStartWhereItHoldsNothing)
{
  const PlanCurve start = lineThrough({0, 9}, {1, 9});
  const PlanCurve line =
      fitRobustly(alongLine(lineThrough({0, 0}, {1, 0}), 0, 1), start, 0.05, 0.1, 25);
  EXPECT_EQ(line.point, start.point);
  EXPECT_EQ(line.direction, start.direction);
}

void
expectMeetings(const PlanCurve& a, const PlanCurve& b, std::vector<Vector2d> truth)
{
  for (const bool swapped : {false, true}) {
    auto points = swapped ? intersections(b, a) : intersections(a, b);
    ASSERT_EQ(points.size(), truth.size());
    for (const auto& t : truth)
      EXPECT_TRUE(std::any_of(points.begin(), points.end(), [&](const auto& p) {
        return (p - t).norm() < 1e-9;
      })) << t.transpose();
  }
}

TEST(Intersections, OfLinesAreOnePointOrNone)
{
  expectMeetings(lineThrough({0, 0}, {1, 1}), lineThrough({0, 4}, {1, 3}), {{2, 2}});
  expectMeetings(lineThrough({0, 0}, {1, 0}), lineThrough({7, -3}, {7, 9}), {{7, 0}});
  expectMeetings(lineThrough({0, 0}, {1, 1}), lineThrough({0, 1}, {1, 2}), {});
  expectMeetings(lineThrough({0, 0}, {1, 1}), lineThrough({3, 3}, {2, 2}), {});
}

TEST(Intersections, OfALineAndACircleAreTwoOrNone)
{
  const PlanCurve circle = circleAt({1, 2}, 5);
  expectMeetings(lineThrough({0, 5}, {1, 5}), circle, {{-3, 5}, {5, 5}});
  expectMeetings(lineThrough({4, 0}, {4, 1}), circle, {{4, -2}, {4, 6}});
  expectMeetings(lineThrough({0, 7.01}, {1, 7.01}), circle, {});
}

TEST(Intersections, OfATangentAreWhereItTouches)
{
  for (const auto& p : intersections(lineThrough({0, 7}, {1, 7}), circleAt({1, 2}, 5)))
    EXPECT_NEAR((p - Vector2d(1, 7)).norm(), 0, 1e-6);
}

TEST(Intersections, OfCirclesAreTwoOrNone)
{
  expectMeetings(circleAt({0, 0}, 5), circleAt({8, 0}, 5), {{4, 3}, {4, -3}});
  expectMeetings(circleAt({0, 0}, 5), circleAt({0, 4}, 3), {{3, 4}, {-3, 4}});
  expectMeetings(circleAt({0, 0}, 5), circleAt({11, 0}, 5), {});
  expectMeetings(circleAt({0, 0}, 5), circleAt({1, 0}, 2), {});
  expectMeetings(circleAt({0, 0}, 5), circleAt({0, 0}, 2), {});
  expectMeetings(circleAt({0, 0}, 5), circleAt({0, 0}, 5), {});
}

TEST(PlanPoints, FindsWhatLookingAtAllFinds)
{
  std::mt19937 random(6);
  std::uniform_real_distribution<double> place(-2, 2);
  std::vector<Vector2d> points;
  for (int i = 0; i < 1500; ++i)
    points.emplace_back(place(random), place(random));
  points.push_back(points.front());
  const PlanPoints index(points, 0.1);
  EXPECT_EQ(index.size(), points.size());
  const auto before = [](const Vector2d& a, const Vector2d& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  };
  for (int i = 0; i < 200; ++i) {
    const Vector2d p(1.2 * place(random), 1.2 * place(random));
    const double radius = 0.01 * static_cast<double>(i);
    std::vector<Vector2d> found;
    std::vector<Vector2d> truth;
    index.forEachWithin(p, radius, [&](const Vector2d& q) { found.push_back(q); });
    for (const auto& q : points)
      if ((q - p).norm() <= radius)
        truth.push_back(q);
    std::sort(found.begin(), found.end(), before);
    std::sort(truth.begin(), truth.end(), before);
    ASSERT_EQ(found, truth) << "radius " << radius;
  }
}

TEST(PlanPoints, OfNothingAndFarAwayFindsNothing)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  int found = 0;
  const auto count = [&](const Vector2d&) { ++found; };
  PlanPoints({}, 0.1).forEachWithin({0, 0}, 5, count);
  const PlanPoints index({{0, 0}, {nan, 0}, {1e12, 0}}, 0.1);
  EXPECT_EQ(index.size(), 1u);
  index.forEachWithin({1e6, 1e6}, 1, count);
  index.forEachWithin({nan, 0}, 1, count);
  index.forEachWithin({1e12, 0}, 1, count);
  EXPECT_EQ(found, 0);
  index.forEachWithin({0.5, 0}, 0.5, count);
  EXPECT_EQ(found, 1) << "the radius itself is within";
}

} // namespace
