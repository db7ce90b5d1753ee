// SPDX-License-Identifier: BSD-3-Clause
#include "plan_loops.h"

#include "sedr_segmentation/src/curves/contour.h"

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

} // namespace
