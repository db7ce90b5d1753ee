// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/curves/cell_contours.h"

#include "sedr_segmentation/src/columns/column_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** Returns points of the sides as after thinning: means of 5 cm along, 20 above each
 * other, with noise, where they are seen. */
PlanPoints
pointsOf(const PlanLoop& column, double noise, const Where& seen = everywhere)
{
  std::mt19937 random(3);
  std::normal_distribution<double> off(0, 1);
  std::uniform_real_distribution<double> along(-0.02, 0.02);
  std::vector<Vector2d> points;
  for (const auto& e : column.elements)
    for (double s = 0.025; s < e.length(); s += 0.05)
      for (int k = 0; k < 20; ++k) {
        const double t = std::clamp(s + along(random), 0.0, e.length());
        if (seen(e.pointAt(t)))
          points.push_back(e.pointAt(t) + noise * off(random) * e.normalAt(t));
      }
  return {points, 0.1};
}

const std::vector<Vector2d> along_axes{{1, 0}, {0, 1}};

/** Expects the kinds of elements of the truth, clockwise; returns the maximum distance
 * of a corner or side from it. */
double
errorOf(const PlanLoop& loop, const PlanLoop& truth)
{
  EXPECT_EQ(loop.elements.size(), truth.elements.size());
  EXPECT_LT(loop.area(), 0);
  double worst = 0;
  for (std::size_t i = 0; i < truth.elements.size(); ++i) {
    const PlanElement& e = truth.elements[i];
    double nearest = 1e9;
    for (const auto& f : loop.elements) {
      EXPECT_EQ(f.isArc(), e.isArc());
      nearest = std::min(nearest, (f.start - e.start).norm());
    }
    worst = std::max(worst, e.isArc() ? 0 : nearest);
    for (const double share : {0.1, 0.5, 0.9})
      worst = std::max(worst, loop.distance(e.pointAt(share * e.length())));
  }
  return worst;
}

TEST(FitColumn, ARectangleAtAnyAngleAndNoise)
{
  for (const double noise : {0.001, 0.01, 0.02})
    for (const double degrees : {0.0, 19.0, 45.0})
      for (const double depth : {0.25, 0.4, 0.7}) {
        SCOPED_TRACE(testing::Message()
                     << depth << " m at " << degrees << ", " << noise);
        const PlanLoop truth = placed(rectangle(-0.2, -depth / 2, 0.2, depth / 2),
                                      degrees, {2.013, 1.027});
        const PlanLoop loop =
            fitColumn(holeOf(truth), pointsOf(truth, noise), along_axes, {});
        EXPECT_LT(errorOf(loop, truth), 0.002 + 0.3 * noise);
        std::size_t shown = 0;
        for (const auto& e : loop.elements)
          shown += e.inliers > 20 ? 1 : 0;
        EXPECT_EQ(shown, 4u);
      }
}

TEST(FitColumn, APlateHasTwoFaces)
{
  for (const double noise : {0.001, 0.01})
    for (const double degrees : {0.0, 19.0})
      for (const double depth : {0.05, 0.08, 0.12}) {
        SCOPED_TRACE(testing::Message()
                     << depth << " m at " << degrees << ", " << noise);
        const PlanLoop truth = placed(rectangle(-1.2, -depth / 2, 1.2, depth / 2),
                                      degrees, {2.012, 1.017});
        const PlanLoop loop =
            fitColumn(holeOf(truth), pointsOf(truth, noise), along_axes, {});
        EXPECT_LT(errorOf(loop, truth), 0.02);
      }
}

TEST(FitColumn, KeepsTheDirectionsOfTheRoomWhereItCan)
{
  // Turned by about the effect of the noise.
  const PlanLoop truth = rectangle(1.01, 1.02, 1.41, 1.32);
  const PlanLoop loop =
      fitColumn(holeOf(truth), pointsOf(truth, 0.015), along_axes, {});
  for (const auto& e : loop.elements)
    EXPECT_NEAR(
        std::min(std::abs(e.end.x() - e.start.x()), std::abs(e.end.y() - e.start.y())),
        0, 1e-12);
}

TEST(FitColumn, ASideInShadowIsWhereTheOthersEnd)
{
  const auto isSeen = [](const Vector2d& p) { return p.x() < 2.2999; };
  const PlanLoop square = rectangle(1.9, 1.03, 2.3, 1.43);
  const PlanLoop oblong = rectangle(1.9, 1.03, 2.3, 1.8);
  for (const double noise : {0.001, 0.02}) {
    SCOPED_TRACE(noise);
    EXPECT_LT(errorOf(fitColumn(holeOf(square), pointsOf(square, noise, isSeen),
                                along_axes, {}),
                      square),
              0.002 + 0.3 * noise)
        << "a square is taken for one";
    EXPECT_LT(errorOf(fitColumn(holeOf(oblong), pointsOf(oblong, noise, isSeen),
                                along_axes, {}),
                      oblong),
              0.025);
  }
}

TEST(FitColumn, OfTwoSidesTheWholeFollows)
{
  const PlanLoop truth = rectangle(1.9, 1.03, 2.3, 1.63);
  const auto isSeen = [](const Vector2d& p) {
    return p.x() < 1.9001 || p.y() < 1.0301;
  };
  const PlanLoop loop =
      fitColumn(holeOf(truth), pointsOf(truth, 0.005, isSeen), along_axes, {});
  EXPECT_LT(errorOf(loop, truth), 0.03);
}

TEST(FitColumn, ARoundColumnIsOneArc)
{
  for (const double noise : {0.001, 0.01, 0.02})
    for (const double radius : {0.15, 0.25, 0.4}) {
      SCOPED_TRACE(testing::Message() << radius << " m, " << noise);
      const PlanLoop truth = reversed(circle({1.01, 2.02}, radius));
      const PlanLoop loop =
          fitColumn(holeOf(truth), pointsOf(truth, noise), along_axes, {});
      EXPECT_LT(errorOf(loop, truth), 0.002 + 0.2 * noise);
      ASSERT_TRUE(loop.elements[0].isArc());
      EXPECT_NEAR(loop.elements[0].radius, radius, 0.001 + 0.2 * noise);
    }
}

TEST(FitColumn, HalfARoundColumnIsEnough)
{
  const PlanLoop truth = reversed(circle({1.01, 2.02}, 0.3));
  const auto isSeen = [](const Vector2d& p) { return p.x() < 1.05; };
  const PlanLoop loop =
      fitColumn(holeOf(truth), pointsOf(truth, 0.005, isSeen), along_axes, {});
  EXPECT_LT(errorOf(loop, truth), 0.01);
}

TEST(FitColumn, OtherShapesKeepTheirs)
{
  const PlanLoop truth = reversed(
      polygon({{1, 1}, {1.9, 1}, {1.9, 1.4}, {1.4, 1.4}, {1.4, 2.1}, {1, 2.1}}));
  const PlanLoop loop =
      fitColumn(holeOf(truth), pointsOf(truth, 0.003), along_axes, {});
  EXPECT_LT(errorOf(loop, truth), 0.006);
}

TEST(FitColumn, WithoutPointsItIsTheHole)
{
  const PlanLoop truth = rectangle(1, 1, 1.4, 1.4);
  const PlanLoop loop = fitColumn(holeOf(truth), PlanPoints({}, 0.1), along_axes, {});
  EXPECT_NEAR(loop.area(), signedArea(holeOf(truth)), 0.06);
  EXPECT_TRUE(fitColumn({}, PlanPoints({}, 0.1), along_axes, {}).elements.empty());
}

TEST(FitColumn, NeverReachesFarBeyondItsHole)
{
  // The sides of a column that continue in others, as beside a low wall.
  const PlanLoop truth = rectangle(1, 1, 1.4, 1.4);
  std::vector<Vector2d> points = pointsOf(truth, 0.003).all();
  for (double x = 1.4; x < 2.2; x += 0.0025)
    for (const double y : {1.0, 1.4})
      points.emplace_back(x, y);
  const PlanLoop loop =
      fitColumn(holeOf(truth), PlanPoints(points, 0.1), along_axes, {});
  EXPECT_LT(errorOf(loop, truth), 0.01);
}

TEST(FitColumn, ACornerWhoseHoleIsCutOffIsThere)
{
  // Ceiling cells cover both sides at a corner.
  const PlanLoop truth = rectangle(1, 1, 1.4, 1.4);
  const Contour hole = holeOf(
      polygon({{1.04, 1.04}, {1.24, 1.04}, {1.36, 1.16}, {1.36, 1.36}, {1.04, 1.36}}));
  const PlanLoop loop = fitColumn(hole, pointsOf(truth, 0.003), along_axes, {});
  EXPECT_LT(errorOf(loop, reversed(truth)), 0.01);
}

} // namespace
