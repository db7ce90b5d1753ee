// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/curves/curve_adjustment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace {

using namespace pcl::sedr;
using Eigen::Vector2d;

/** Returns a line through a pivot, angle in degrees, measured by `count` points. */
MeasuredCurve
line(const Vector2d& pivot, double degrees, double count = 100, double length = 4)
{
  MeasuredCurve m;
  const double a = degrees * M_PI / 180;
  m.curve.point = pivot;
  m.curve.direction = {std::cos(a), std::sin(a)};
  m.pivot = pivot;
  m.information = lineInformation(count, 0.01, length);
  return m;
}

MeasuredCurve
circle(const Vector2d& centre, double radius, double count = 100)
{
  MeasuredCurve m;
  m.curve.point = centre;
  m.curve.radius = radius;
  m.information = circleInformation(count, 0.01, 0, 2 * M_PI);
  return m;
}

double
angle(const MeasuredCurve& m)
{
  return std::atan2(m.curve.direction.y(), m.curve.direction.x()) * 180 / M_PI;
}

TEST(AdjustCurves, ParallelLinesMeetInTheirWeightedMean)
{
  std::vector<MeasuredCurve> curves{line({0, 0}, 0, 300), line({0, 3}, 1, 100)};
  ASSERT_TRUE(adjustCurves(curves, {{TieKind::Parallel, 0, 1}}));
  EXPECT_NEAR(angle(curves[0]), 0.25, 1e-9);
  EXPECT_NEAR(angle(curves[1]), 0.25, 1e-9);
  // Each turns about its own centre.
  EXPECT_NEAR(curves[0].curve.distance({0, 0}), 0, 1e-12);
  EXPECT_NEAR(curves[1].curve.distance({0, 3}), 0, 1e-12);
}

TEST(AdjustCurves, ALongLineIsWorthMoreThanAShortOne)
{
  // The shares follow the cube of the length at equal density.
  std::vector<MeasuredCurve> curves{line({0, 0}, 0, 200, 2),
                                    line({0, 3}, 90.9, 100, 1)};
  ASSERT_TRUE(adjustCurves(curves, {{TieKind::Perpendicular, 0, 1}}));
  EXPECT_NEAR(angle(curves[0]), 0.1, 1e-9);
  EXPECT_NEAR(angle(curves[1]), 90.1, 1e-9);
}

TEST(AdjustCurves, LinesHaveNoSense)
{
  std::vector<MeasuredCurve> curves{line({0, 0}, 0), line({0, 3}, 179)};
  ASSERT_TRUE(adjustCurves(curves, {{TieKind::Parallel, 0, 1}}));
  EXPECT_NEAR(angle(curves[0]), -0.5, 1e-9);
  EXPECT_NEAR(angle(curves[1]), 179.5, 1e-9);
}

TEST(AdjustCurves, CollinearLinesBecomeOne)
{
  std::vector<MeasuredCurve> curves{line({0, 0}, 0), line({10, 0.02}, 0)};
  ASSERT_TRUE(adjustCurves(curves, {{TieKind::Collinear, 0, 1}}));
  for (const double x : {-5.0, 0.0, 5.0, 20.0})
    EXPECT_NEAR(curves[0].curve.signedDistance({x, 1}),
                curves[1].curve.signedDistance({x, 1}), 1e-9);
  EXPECT_NEAR(curves[0].curve.distance({5, 0.01}), 0, 1e-12) << "by symmetry";
}

TEST(AdjustCurves, ALineTouchesACircleFromItsSide)
{
  for (const double side : {1.0, -1.0}) {
    std::vector<MeasuredCurve> curves{line({0, 0}, 0), circle({0.3, side * 1.01}, 1)};
    ASSERT_TRUE(adjustCurves(curves, {{TieKind::Tangent, 0, 1}}));
    EXPECT_NEAR(curves[0].curve.distance(curves[1].curve.point), curves[1].curve.radius,
                1e-9);
    EXPECT_GT(side * curves[1].curve.point.y(), 0);
    EXPECT_NEAR(curves[1].curve.radius, 1, 0.01);
    const Vector2d touch = touchingPoint(curves[0].curve, curves[1].curve);
    EXPECT_NEAR(curves[0].curve.distance(touch), 0, 1e-9);
    EXPECT_NEAR(curves[1].curve.distance(touch), 0, 1e-9);
  }
}

TEST(AdjustCurves, CirclesTouchFromOutsideAndFromInside)
{
  for (const auto& [centre, radius] : {std::pair<Vector2d, double>{{3.02, 0}, 1},
                                       {{0.98, 0.1}, 1},
                                       {{1.0, 0.2}, 3.05}}) {
    std::vector<MeasuredCurve> curves{circle({0, 0}, 2), circle(centre, radius)};
    const double apart = centre.norm();
    ASSERT_TRUE(adjustCurves(curves, {{TieKind::Tangent, 0, 1}}));
    const double now = (curves[0].curve.point - curves[1].curve.point).norm();
    const double a = curves[0].curve.radius;
    const double b = curves[1].curve.radius;
    EXPECT_NEAR(now, apart > 2.5 ? a + b : std::abs(a - b), 1e-9);
    EXPECT_NEAR(a, 2, 0.03);
    EXPECT_NEAR(b, radius, 0.03);
    const Vector2d touch = touchingPoint(curves[0].curve, curves[1].curve);
    EXPECT_NEAR(curves[0].curve.distance(touch), 0, 1e-9);
    EXPECT_NEAR(curves[1].curve.distance(touch), 0, 1e-9);
  }
}

TEST(AdjustCurves, EqualRadiiAndCommonCentresAreWeightedMeans)
{
  std::vector<MeasuredCurve> curves{circle({0, 0}, 1, 300), circle({5, 0}, 1.04, 100)};
  ASSERT_TRUE(adjustCurves(curves, {{TieKind::EqualRadius, 0, 1}}));
  EXPECT_NEAR(curves[0].curve.radius, 1.01, 1e-9);
  EXPECT_NEAR(curves[1].curve.radius, 1.01, 1e-9);
  curves = {circle({0, 0}, 1, 300), circle({0.04, -0.08}, 2, 100)};
  ASSERT_TRUE(adjustCurves(curves, {{TieKind::Concentric, 0, 1}}));
  for (const auto& c : curves)
    EXPECT_NEAR((c.curve.point - Vector2d(0.01, -0.02)).norm(), 0, 1e-9);
}

TEST(AdjustCurves, TiesThatRepeatEachOtherAreFine)
{
  // A rectangle: four right angles, the last of which follows from the others.
  std::vector<MeasuredCurve> curves{line({2, 0}, 0.1), line({4, 2}, 90),
                                    line({2, 4}, 180.1), line({0, 2}, 270.3)};
  ASSERT_TRUE(adjustCurves(curves, {{TieKind::Perpendicular, 0, 1},
                                    {TieKind::Perpendicular, 1, 2},
                                    {TieKind::Perpendicular, 2, 3},
                                    {TieKind::Perpendicular, 3, 0},
                                    {TieKind::Parallel, 0, 2}}));
  EXPECT_NEAR(angle(curves[0]), 0.125, 1e-9);
  EXPECT_NEAR(angle(curves[1]), 90.125, 1e-9);
}

TEST(AdjustCurves, WhatCannotBeFulfilledChangesNothing)
{
  // Contradictory ties have no solution.
  std::vector<MeasuredCurve> curves{line({0, 0}, 0), line({0, 1}, 0)};
  ASSERT_FALSE(adjustCurves(
      curves, {{TieKind::Parallel, 0, 1}, {TieKind::Perpendicular, 0, 1}}));
  EXPECT_EQ(angle(curves[0]), 0);
  EXPECT_EQ(angle(curves[1]), 0);
}

TEST(Contradiction, IsTheSquareOfTheStandardDeviations)
{
  // The direction of 100 points with noise of 1 cm along 4 m has a deviation of 0.87
  // mrad, the angle between two such lines 1.22 mrad.
  const double deviation = std::sqrt(2.0) * 0.01 / (4 / std::sqrt(12.0) * 10);
  for (const double sigmas : {0.5, 1.0, 4.0})
    EXPECT_NEAR(contradiction(line({0, 0}, 0),
                              line({0, 1}, sigmas * deviation * 180 / M_PI),
                              TieKind::Parallel),
                sigmas * sigmas, 1e-6);
}

TEST(Contradiction, IsOneOnAverageWhereTheTieIsTrue)
{
  std::mt19937 random(5);
  std::normal_distribution<double> off(0, 0.01);
  double sum = 0;
  constexpr int trials = 300;
  for (int trial = 0; trial < trials; ++trial) {
    // A line and a tangent circle, each fitted to 200 points.
    std::vector<WeightedPoint> on_line;
    std::vector<WeightedPoint> on_circle;
    for (int k = 0; k < 200; ++k) {
      on_line.push_back({{(k + 0.5) / 50 - 2, off(random)}, 1});
      const double a = 2 * M_PI * k / 200;
      const double r = 1 + off(random);
      on_circle.push_back({{r * std::cos(a), 1 + r * std::sin(a)}, 1});
    }
    MeasuredCurve a = line({0, 0}, 0, 200);
    MeasuredCurve b = circle({0, 1}, 1, 200);
    a.curve = fitLine(on_line);
    b.curve = fitCircle(on_circle, b.curve);
    sum += contradiction(a, b, TieKind::Tangent);
  }
  EXPECT_NEAR(sum / trials, 1, 0.25);
}

} // namespace
