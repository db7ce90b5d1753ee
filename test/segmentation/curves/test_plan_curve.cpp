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
PlanCurve
circleAt(const Vector2d& centre, double radius)
{
  PlanCurve curve;
  curve.point = centre;
  curve.radius = radius;
  return curve;
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
