// SPDX-License-Identifier: BSD-3-Clause
#include "loop_scenes.h"

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

const double angles[] = {0, 3, 17, 30, 45, 62, 88};

TEST(FitLoop, ARectangleAtAnyAngle)
{
  for (const double degrees : angles) {
    SCOPED_TRACE(degrees);
    const PlanLoop truth = placed(rectangle(0, 0, 4, 3), degrees, {1.013, -7.021});
    expectLoop(fitted(contourIn(truth), wallPoints(truth)), truth, 0.002);
    expectLoop(fitted(contourIn(truth), wallPoints(truth, 0.02)), truth, 0.008);
  }
}

TEST(FitLoop, ARectangleWhateverItsPlaceInTheGrid)
{
  for (double shift = 0; shift < cell; shift += 0.007) {
    SCOPED_TRACE(shift);
    const PlanLoop truth = rectangle(shift, -shift, 4, 3 + shift / 2);
    expectLoop(fitted(contourIn(truth), wallPoints(truth)), truth, 0.002);
  }
}

TEST(FitLoop, AnLShapeAtAnyAngle)
{
  for (const double degrees : angles) {
    SCOPED_TRACE(degrees);
    const PlanLoop truth = placed(
        polygon({{0, 0}, {5, 0}, {5, 2}, {2, 2}, {2, 4}, {0, 4}}), degrees, {9, 9});
    expectLoop(fitted(contourIn(truth), wallPoints(truth, 0.005)), truth, 0.005);
  }
}

TEST(FitLoop, ARoundRoomIsOneCircle)
{
  const PlanLoop truth = circle({3.02, 1.01}, 2);
  const PlanLoop loop = fitted(contourIn(truth), wallPoints(truth, 0.01));
  ASSERT_EQ(loop.elements.size(), 1u);
  const PlanElement& e = loop.elements[0];
  EXPECT_TRUE(e.isArc());
  EXPECT_NEAR((e.centre - Vector2d(3.02, 1.01)).norm(), 0, 0.003);
  EXPECT_NEAR(e.radius, 2, 0.003);
  EXPECT_DOUBLE_EQ(e.sweep(), 2 * M_PI);
  EXPECT_GT(e.inliers, 1000u);
  EXPECT_NEAR(e.residual, 0.01, 0.003);
}

TEST(FitLoop, ACurvedWallBetweenStraightOnes)
{
  // An arc of 5 m that meets the side walls at an angle.
  const double half = std::asin(3.0 / 5) * 180 / M_PI;
  for (const double degrees : {0.0, 20.0, 45.0}) {
    SCOPED_TRACE(degrees);
    const PlanLoop truth =
        placed({{segment({-3, 0}, {3, 0}), segment({3, 0}, {3, 4}),
                 arc({0, 0}, 5, 90 - half, 90 + half), segment({-3, 4}, {-3, 0})}},
               degrees, {0.01, 0.02});
    const PlanLoop loop = fitted(contourIn(truth), wallPoints(truth, 0.005));
    expectLoop(loop, truth, 0.01);
    for (const auto& e : loop.elements)
      if (e.isArc()) {
        EXPECT_NEAR(e.radius, 5, 0.03);
        EXPECT_TRUE(e.counter_clockwise);
      }
  }
}

TEST(FitLoop, ACurvedWallThatBulgesIn)
{
  const PlanLoop truth = bittenRectangle(6, 4, 1.2);
  const PlanLoop loop = fitted(contourIn(truth), wallPoints(truth, 0.005));
  expectLoop(loop, truth, 0.01);
  for (const auto& e : loop.elements)
    if (e.isArc()) {
      EXPECT_FALSE(e.counter_clockwise);
      EXPECT_NEAR(e.radius, 1.2, 0.01);
    }
}

TEST(FitLoop, ArcsTangentToWallsAreOneArcEach)
{
  for (const auto& truth : {stadium(4, 1.5), roundedRectangle(6, 4, 1)})
    for (const double degrees : {0.0, 33.0}) {
      SCOPED_TRACE(testing::Message() << truth.elements.size() << " at " << degrees);
      const PlanLoop there = placed(truth, degrees, {0.017, 0.023});
      const PlanLoop loop = fitted(contourIn(there), wallPoints(there, 0.003));
      EXPECT_EQ(loop.elements.size(), there.elements.size());
      EXPECT_NEAR(loop.area(), there.area(), 0.001 * there.length());
      for (const auto& e : there.elements)
        for (double share = 0.05; share < 1; share += 0.1)
          EXPECT_LT(loop.distance(e.pointAt(share * e.length())), 0.003)
              << e.pointAt(share * e.length()).transpose();
      for (const auto& e : loop.elements)
        if (e.isArc()) {
          EXPECT_NEAR(e.radius, truth.elements[1].radius, 0.01);
        }
    }
}

TEST(FitLoop, AnSCurveIsTwoArcs)
{
  // The right wall of a room continues over two arcs of 2 m into another line, each
  // tangent to the next.
  const double a = 50 * M_PI / 180;
  const Vector2d middle(2 - 2 * std::cos(a), 2 * std::sin(a));
  const double x = 2 * middle.x();
  const double y = 2 * middle.y();
  const PlanLoop truth{{segment({-3, -1.5}, {0, -1.5}), segment({0, -1.5}, {0, 0}),
                        arc({2, 0}, 2, 180, 130), arc({x - 2, y}, 2, -50, 0),
                        segment({x, y}, {x, y + 1.2}),
                        segment({x, y + 1.2}, {-3, y + 1.2}),
                        segment({-3, y + 1.2}, {-3, -1.5})}};
  for (const double noise : {0.001, 0.01, 0.02}) {
    SCOPED_TRACE(noise);
    const PlanLoop loop = fitted(contourIn(truth), wallPoints(truth, noise));
    EXPECT_EQ(loop.elements.size(), 7u);
    double total = 0;
    for (const auto& e : loop.elements)
      if (e.isArc()) {
        EXPECT_NEAR(e.radius, 2, 0.02 + 2 * noise);
        total += std::abs(e.sweep());
      }
    EXPECT_NEAR(total, 2 * a, 0.15);
    for (const auto& e : truth.elements)
      for (double share = 0.05; share < 1; share += 0.1)
        EXPECT_LT(loop.distance(e.pointAt(share * e.length())), 0.002 + noise / 4)
            << e.pointAt(share * e.length()).transpose();
  }
}

TEST(FitLoop, AStraightWallIsNoArc)
{
  const PlanLoop truth = placed(rectangle(0, 0, 12, 3), 7, {0, 0});
  for (const auto& e : fitted(contourIn(truth), wallPoints(truth, 0.02)).elements)
    EXPECT_FALSE(e.isArc());
}

TEST(FitLoop, ASquareColumnHasFourStraightSides)
{
  for (const double side : {0.4, 0.6})
    for (const double degrees : {0.0, 30.0, 45.0}) {
      SCOPED_TRACE(testing::Message() << side << " m at " << degrees);
      const double half = side / 2;
      const PlanLoop truth =
          placed(rectangle(-half, -half, half, half), degrees, {2.013, 1.027});
      // The room's cells around a column are the next complete cells outside it.
      const PlanLoop around =
          placed(rectangle(-half - 0.05, -half - 0.05, half + 0.05, half + 0.05),
                 degrees, {2.013, 1.027});
      Contour contour = contourIn(around);
      std::reverse(contour.begin(), contour.end());
      expectLoop(fitted(contour, wallPoints(truth, 0.003)), reversed(truth), 0.012);
    }
}

TEST(FitLoop, ARoundColumnIsACircleThatRunsClockwise)
{
  for (const double radius : {0.2, 0.3, 0.5}) {
    SCOPED_TRACE(radius);
    Contour contour = contourIn(circle({1.01, 2.02}, radius + 0.05));
    std::reverse(contour.begin(), contour.end());
    const PlanLoop loop =
        fitted(contour, wallPoints(circle({1.01, 2.02}, radius), 0.003));
    ASSERT_EQ(loop.elements.size(), 1u);
    EXPECT_TRUE(loop.elements[0].isArc());
    EXPECT_FALSE(loop.elements[0].counter_clockwise);
    EXPECT_NEAR(loop.elements[0].radius, radius, 0.005);
    EXPECT_NEAR((loop.elements[0].centre - Vector2d(1.01, 2.02)).norm(), 0, 0.005);
  }
}

TEST(FitLoop, APilasterOfTenCentimetresIsKept)
{
  // Its sides are too short for curves of their own and stay at the edges of the cells.
  const PlanLoop truth =
      polygon({{0, 0}, {2, 0}, {2, 0.1}, {2.5, 0.1}, {2.5, 0}, {5, 0}, {5, 3}, {0, 3}});
  for (const double degrees : {0.0, 25.0}) {
    SCOPED_TRACE(degrees);
    const PlanLoop there = placed(truth, degrees, {0.02, 0.013});
    const PlanLoop loop = fitted(contourIn(there), wallPoints(there, 0.003));
    expectLoop(loop, there, 0.03);
    for (const std::size_t e : {0u, 2u, 4u, 5u, 6u, 7u}) {
      const PlanElement& wall = there.elements[e];
      EXPECT_LT(loop.distance(wall.pointAt(wall.length() / 2)), 0.003) << e;
    }
  }
}

TEST(FitLoop, APilasterInACornerIsNotCutOff)
{
  const PlanLoop truth =
      polygon({{0, 0}, {4, 0}, {4, 3}, {0.2, 3}, {0.2, 2.85}, {0, 2.85}});
  for (const double degrees : {0.0, 19.0, 45.0})
    for (const double noise : {0.001, 0.01, 0.02}) {
      SCOPED_TRACE(testing::Message() << degrees << " noise " << noise);
      const PlanLoop there = placed(truth, degrees, {0.01, 0.02});
      expectLoop(fitted(contourIn(there, awayFromCorners(there, 0.1)),
                        wallPoints(there, noise)),
                 there, 0.003 + noise / 2);
    }
}

TEST(FitLoop, ANicheAndAPilasterInAWallHaveRightAngles)
{
  const PlanLoop truth = polygon({{0, 0},
                                  {1, 0},
                                  {1, 0.15},
                                  {1.4, 0.15},
                                  {1.4, 0},
                                  {2.5, 0},
                                  {2.5, -0.2},
                                  {2.9, -0.2},
                                  {2.9, 0},
                                  {5, 0},
                                  {5, 3},
                                  {0, 3}});
  for (const double degrees : {0.0, 25.0})
    for (const double noise : {0.003, 0.015}) {
      SCOPED_TRACE(testing::Message() << degrees << " noise " << noise);
      const PlanLoop there = placed(truth, degrees, {0.02, 0.013});
      expectLoop(fitted(contourIn(there, awayFromCorners(there, 0.07)),
                        wallPoints(there, noise)),
                 there, 0.004 + noise / 2);
    }
}

TEST(FitLoop, AFlatAngleIsKeptWhereTheNoiseShowsIt)
{
  // The upper wall is bent by six degrees.
  const PlanLoop truth = polygon({{0, 0}, {6, 0}, {6, 3}, {3, 3.315}, {0, 3}});
  for (const double noise : {0.001, 0.02}) {
    SCOPED_TRACE(noise);
    const PlanLoop loop = fitted(contourIn(truth), wallPoints(truth, noise));
    EXPECT_EQ(loop.elements.size(), 5u);
    EXPECT_LT(loop.distance({3, 3.315}), 0.003 + noise / 4);
  }
}

} // namespace
