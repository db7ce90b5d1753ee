// SPDX-License-Identifier: BSD-3-Clause
#include "plan_loops.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;
using Eigen::Vector2d;

/** A segment and arcs of both directions: short, more than half, and whole circles. */
std::vector<PlanElement>
elements()
{
  return {segment({1, 2}, {4, 6}),        arc({1, 2}, 3, 20, 95),
          arc({1, 2}, 3, 95, 20),         arc({-2, 0}, 0.5, 170, 410),
          arc({-2, 0}, 0.5, 410, 170),    arc({5, 5}, 2, 30, 390),
          arc({5, 5}, 2, 390, 30),        arc({0, 0}, 40, 179, 181),
          arc({1e4, -1e4}, 2, -100, 100), segment({1e4, 1e4}, {1e4 - 3, 1e4})};
}

TEST(PlanElement, SweepsTheAngleOfItsSense)
{
  EXPECT_NEAR(arc({0, 0}, 1, 0, 90).sweep(), M_PI / 2, 1e-12);
  EXPECT_NEAR(arc({0, 0}, 1, 90, 0).sweep(), -M_PI / 2, 1e-12);
  EXPECT_NEAR(arc({3, 4}, 2, 90, 360).sweep(), 3 * M_PI / 2, 1e-12);
  EXPECT_NEAR(arc({3, 4}, 2, 360, 90).sweep(), -3 * M_PI / 2, 1e-12);
  EXPECT_NEAR(arc({0, 0}, 1, 170, 190).sweep(), M_PI / 9, 1e-12) << "across -x";
  EXPECT_NEAR(arc({0, 0}, 1, 190, 170).sweep(), -M_PI / 9, 1e-12);
}

TEST(PlanElement, PointAtGoesFromStartToEndAtUnitSpeed)
{
  for (const auto& e : elements()) {
    const double length = e.length();
    EXPECT_NEAR((e.pointAt(0) - e.start).norm(), 0, 1e-9);
    EXPECT_NEAR((e.pointAt(length) - e.end).norm(), 0, 1e-9);
    constexpr double step = 1e-4;
    for (double s = 0; s + step <= length; s += length / 17)
      ASSERT_NEAR((e.pointAt(s + step) - e.pointAt(s)).norm() / step, 1, 1e-6);
  }
  EXPECT_NEAR(
      (arc({0, 0}, 1, 0, 90).pointAt(M_PI / 4) - Vector2d(1, 1).normalized()).norm(), 0,
      1e-12);
  EXPECT_NEAR(
      (arc({0, 0}, 1, 0, -90).pointAt(M_PI / 4) - Vector2d(1, -1).normalized()).norm(),
      0, 1e-12);
  EXPECT_EQ(segment({1, 2}, {1, 2}).pointAt(0), Vector2d(1, 2));
}

TEST(PlanElement, IsBesideWhatItsNormalsLeadTo)
{
  PlanElement line;
  line.start = {1, 1};
  line.end = {3, 1};
  EXPECT_TRUE(line.isBeside({2, 5}));
  EXPECT_FALSE(line.isBeside({0.9, 1}));
  EXPECT_FALSE(line.isBeside({3.1, -4}));
  for (const double turn : {0.3, 1.5, 3.0, 3.3, 5.9})
    for (const bool counter_clockwise : {true, false}) {
      PlanElement arc;
      arc.centre = {4, -2};
      arc.radius = 2;
      arc.counter_clockwise = counter_clockwise;
      const auto at = [&](double angle) {
        const double signed_angle = 0.7 + (counter_clockwise ? angle : -angle);
        return Eigen::Vector2d(std::cos(signed_angle), std::sin(signed_angle));
      };
      arc.start = arc.centre + 2 * at(0);
      arc.end = arc.centre + 2 * at(turn);
      for (double angle = 0.05; angle < 6.28; angle += 0.1)
        for (const double from_centre : {0.5, 2.0, 7.0}) {
          const Eigen::Vector2d p = arc.centre + from_centre * at(angle);
          EXPECT_EQ(arc.isBeside(p), angle < turn) << turn << " " << angle;
          const double expected =
              angle < turn ? std::abs(from_centre - 2)
                           : std::min((p - arc.start).norm(), (p - arc.end).norm());
          EXPECT_NEAR(arc.distance(p), expected, 1e-12);
        }
    }
}

} // namespace
