// SPDX-License-Identifier: BSD-3-Clause
#include "plan_loops.h"
#include "sedr_segmentation/src/curves/loop_difference.h"

#include <gtest/gtest.h>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

TEST(LoopDifference, AnIntersectionIsWhatBothHold)
{
  const PlanLoop loop = rectangle(0, 0, 4, 3);
  using Areas = std::vector<double>;
  const auto areasOf = [](const PlanLoop& a, const PlanLoop& b) {
    Areas areas;
    for (const PlanLoop& part : intersection(a, b))
      areas.push_back(std::round(1e9 * part.area()) / 1e9);
    return areas;
  };
  EXPECT_EQ(areasOf(loop, rectangle(3, 1, 6, 2)), Areas{1});
  EXPECT_EQ(areasOf(loop, rectangle(1, 1, 2, 2)), Areas{1}) << "within";
  EXPECT_EQ(areasOf(loop, rectangle(3, 0, 6, 3)), Areas{3}) << "two sides in line";
  EXPECT_EQ(areasOf(loop, loop), Areas{12}) << "the same";
  EXPECT_EQ(areasOf(loop, rectangle(-1, -1, 5, 4)), Areas{12}) << "around";
  EXPECT_EQ(areasOf(loop, rectangle(4, 0, 6, 3)), Areas{}) << "beside";
  EXPECT_EQ(
      areasOf(
          rectangle(0, 1.5, 4, 2.5),
          polygon({{-1, 0}, {5, 0}, {5, 3}, {3, 3}, {3, 1}, {2, 1}, {2, 3}, {-1, 3}})),
      (Areas{2, 1}));
  EXPECT_NEAR(intersection(circle({0, 0}, 5), circle({8, 0}, 5)).at(0).area(),
              50 * std::acos(0.8) - 24, 1e-9)
      << "a lens";
}

} // namespace
