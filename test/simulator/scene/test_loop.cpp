// SPDX-License-Identifier: BSD-3-Clause
#include "simulator/scene/loop.h"

#include <gtest/gtest.h>

namespace pcl::sedr::sim {
namespace {

/** @brief Returns a 4 x 2 rectangle with half circles at its left and right. */
Loop
stadium()
{
  return {{{0.0, 0.0}}, {{4.0, 0.0}, 1.0}, {{4.0, 2.0}}, {{0.0, 2.0}, 1.0}};
}

TEST(Loop, areaAndPerimeterOfStadiumAreExact)
{
  EXPECT_NEAR(areaOf(stadium()), 8.0 + pi, 1e-12);
  EXPECT_NEAR(perimeterOf(stadium()), 8.0 + 2.0 * pi, 1e-12);
}

TEST(Loop, circleContainsItsCenterAndNothingBeyondItsRadius)
{
  const Loop circle = circleLoop({1.0, 2.0}, 0.5);
  EXPECT_NEAR(areaOf(circle), 0.25 * pi, 1e-12);
  EXPECT_TRUE(contains(circle, {1.0, 2.0}));
  for (int i = 0; i < 36; ++i) {
    const Vec2 direction = rotated({1.0, 0.0}, i * pi / 18.0);
    EXPECT_TRUE(contains(circle, Vec2{1.0, 2.0} + 0.499 * direction)) << i;
    EXPECT_FALSE(contains(circle, Vec2{1.0, 2.0} + 0.501 * direction)) << i;
  }
}

TEST(Loop, containsTakesArcsExactlyInAndOut)
{
  EXPECT_TRUE(contains(stadium(), {4.99, 1.0}));
  EXPECT_FALSE(contains(stadium(), {5.01, 1.0}));
  EXPECT_FALSE(contains(stadium(), {4.9, 1.9}));
  Loop dented = stadium();
  dented[1].bulge = -1.0;
  EXPECT_FALSE(contains(dented, {3.1, 1.0}));
  EXPECT_TRUE(contains(dented, {2.9, 1.0}));
  EXPECT_NEAR(areaOf(dented), 8.0, 1e-12);
}

TEST(Loop, bulgeGivesTheRadiusAskedFor)
{
  const Element element{{0.0, 0.0}, {0.0, 11.0}, bulgeOf(11.0, 8.0)};
  const Arc arc = arcOf(element);
  EXPECT_NEAR(arc.radius, 8.0, 1e-12);
  EXPECT_NEAR(arc.center.x, -std::sqrt(64.0 - 5.5 * 5.5), 1e-12);
  EXPECT_NEAR(lengthOf(element), 16.0 * std::asin(5.5 / 8.0), 1e-12);
}

TEST(Loop, pointAtAndLocateAreInverse)
{
  for (const double bulge : {0.0, 0.3, -0.7, 1.0}) {
    const Element element{{1.0, 2.0}, {4.0, -1.0}, bulge};
    const double end = lengthOf(element);
    for (const double share : {0.0, 0.1, 0.5, 0.9, 1.0}) {
      const auto s = locate(element, pointAt(element, share * end), 1e-6);
      ASSERT_TRUE(s.has_value()) << bulge;
      EXPECT_NEAR(*s, share * end, 1e-9) << bulge;
    }
    const Vec2 beside =
        pointAt(element, 0.5 * end) + 0.01 * rightNormalAt(element, 0.5 * end);
    EXPECT_FALSE(locate(element, beside, 1e-3).has_value()) << bulge;
  }
}

TEST(Loop, pieceOfArcStaysOnItsCircle)
{
  const Element element{{0.0, 0.0}, {0.0, 2.0}, 0.4};
  const Element piece = pieceOf(element, 0.3, 1.1);
  EXPECT_NEAR(lengthOf(piece), 0.8, 1e-12);
  EXPECT_NEAR(arcOf(piece).radius, arcOf(element).radius, 1e-12);
  EXPECT_NEAR(length(arcOf(piece).center - arcOf(element).center), 0.0, 1e-12);
}

TEST(Loop, offsetOutwardsGrowsTheRadius)
{
  const Element element{{0.0, 0.0}, {0.0, 2.0}, 0.4};
  const Element far = offsetRight(element, 0.35);
  EXPECT_NEAR(arcOf(far).radius, arcOf(element).radius + 0.35, 1e-12);
  EXPECT_NEAR(length(arcOf(far).center - arcOf(element).center), 0.0, 1e-12);
}

TEST(Loop, boundsReachTheTopOfAnArc)
{
  const Rectangle bounds = boundsOf(stadium());
  EXPECT_NEAR(bounds.min.x, -1.0, 1e-12);
  EXPECT_NEAR(bounds.max.x, 5.0, 1e-12);
  EXPECT_NEAR(bounds.max.y, 2.0, 1e-12);
}

} // namespace
} // namespace pcl::sedr::sim
