// SPDX-License-Identifier: BSD-3-Clause
#include "plan_loops.h"
#include "sedr_segmentation/src/curves/contour.h"
#include "sedr_segmentation/src/curves/loop_difference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace {

using namespace pcl::sedr;
using sedr_test::Corners;

TEST(CrossesItself, SaysWhetherEdgesThatAreNotNeighboursMeet)
{
  EXPECT_FALSE(crossesItself({{0, 0}, {4, 0}, {4, 3}, {0, 3}}));
  EXPECT_TRUE(crossesItself({{0, 0}, {4, 3}, {4, 0}, {0, 3}})) << "a bow";
  EXPECT_FALSE(crossesItself({{0, 0}, {4, 0}, {4, 3}, {2, 0.01}, {0, 3}}));
  EXPECT_TRUE(crossesItself({{0, 0}, {4, 0}, {4, 3}, {2, 0}, {0, 3}}))
      << "a corner on an edge";
  EXPECT_TRUE(crossesItself({{0, 0}, {4, 0}, {4, 3}, {2, -0.01}, {0, 3}}));
  EXPECT_TRUE(crossesItself({{0, 0}, {4, 0}, {4, 2}, {3, 0}, {1, 0}, {0, 2}}))
      << "edges on one line that overlap";
  EXPECT_FALSE(
      crossesItself({{0, 0}, {1, 0}, {1, 1}, {2, 1}, {2, 0}, {3, 0}, {3, 2}, {0, 2}}))
      << "edges on one line that do not";
  EXPECT_TRUE(crossesItself({{0, 0}, {4, 0}, {4, 3}, {3, -1}}))
      << "the last edge crosses too";
  EXPECT_FALSE(crossesItself({}));
}

TEST(Simplified, LeavesNoCornerFartherThanTheTolerance)
{
  std::mt19937 random(9);
  Corners star;
  for (int i = 0; i < 400; ++i) {
    const double a = 2 * M_PI * i / 400;
    const double r = 3 + 0.2 * static_cast<double>(random()) / 4294967296.0;
    star.emplace_back(r * std::cos(a), r * std::sin(a));
  }
  std::size_t last = star.size() + 1;
  for (const double tolerance : {0.0, 0.05, 0.2, 0.5}) {
    const Corners result = simplified(star, tolerance);
    EXPECT_LT(result.size(), last);
    last = result.size();
    for (const auto& p : star) {
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < result.size(); ++i)
        least = std::min(
            least,
            sedr_test::segment(result[i], result[(i + 1) % result.size()]).distance(p));
      ASSERT_LE(least, tolerance + 1e-9);
    }
  }
  EXPECT_LT(last, 40u);
}

TEST(SimplifiedLine, OfALineThatEndsWhereItStartsKeepsWhatLiesFarFromThere)
{
  const Corners line{{0, 0}, {2, 0}, {2, 2}, {1, 2.01}, {0, 2}, {0, 0}};
  EXPECT_EQ(simplifiedLine(line, 0.1),
            (Corners{{0, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 0}}));
}

using namespace sedr_test;

TEST(LoopDifference, ArcsStayArcs)
{
  // The segment of the unit circle beyond x = 0.5 spans 120 degrees.
  const auto parts = difference(circle({0, 0}, 1), rectangle(0.5, -2, 2, 2));
  ASSERT_EQ(parts.size(), 1u);
  const double taken = M_PI / 3 - std::sqrt(3.0) / 4;
  EXPECT_NEAR(parts[0].area(), M_PI - taken, 1e-9);
  double along_arcs = 0;
  for (const auto& e : parts[0].elements)
    along_arcs += e.isArc() ? e.length() : 0;
  EXPECT_NEAR(along_arcs, 4 * M_PI / 3, 1e-6);
}

TEST(LoopDifference, TwoDiscsShareALens)
{
  const auto parts = intersection(circle({0, 0}, 5), circle({8, 0}, 5));
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_NEAR(parts[0].area(), 50 * std::acos(0.8) - 24, 1e-9);
}

TEST(LoopDifference, AnIntersectionIsWhatBothHold)
{
  const PlanLoop loop = rectangle(0, 0, 4, 3);
  const auto areaWith = [&](const PlanLoop& other) {
    const auto parts = intersection(loop, other);
    EXPECT_EQ(parts.size(), 1u);
    return parts.empty() ? 0 : parts[0].area();
  };
  EXPECT_NEAR(areaWith(rectangle(3, 1, 6, 2)), 1, 1e-9);
  EXPECT_NEAR(areaWith(rectangle(1, 1, 2, 2)), 1, 1e-9) << "within";
  EXPECT_NEAR(areaWith(rectangle(3, 0, 6, 3)), 3, 1e-9) << "two sides in line";
  EXPECT_NEAR(areaWith(rectangle(0, 0, 4, 3)), 12, 1e-9) << "the same";
  EXPECT_NEAR(areaWith(rectangle(-1, -1, 5, 4)), 12, 1e-9) << "around";
  EXPECT_TRUE(intersection(loop, rectangle(4, 0, 6, 3)).empty()) << "beside";
}

TEST(LoopDifference, AnIntersectionMayHaveSeveralParts)
{
  const auto parts = intersection(
      rectangle(0, 1.5, 4, 2.5),
      polygon({{-1, 0}, {5, 0}, {5, 3}, {3, 3}, {3, 1}, {2, 1}, {2, 3}, {-1, 3}}));
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_NEAR(parts[0].area(), 2, 1e-9);
  EXPECT_NEAR(parts[1].area(), 1, 1e-9);
}

} // namespace
