// SPDX-License-Identifier: BSD-3-Clause
#include "plan_loops.h"
#include "sedr_segmentation/src/curves/loop_difference.h"

#include <gtest/gtest.h>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

TEST(LoopDifference, ArcsStayArcs)
{
  // The segment of the unit circle beyond x = 0.5 spans 120 degrees.
  const auto parts = difference(circle({0, 0}, 1), rectangle(0.5, -2, 2, 2));
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_NEAR(parts[0].area(), M_PI - (M_PI / 3 - std::sqrt(3.0) / 4), 1e-9);
  double along_arcs = 0;
  for (const auto& e : parts[0].elements)
    along_arcs += e.isArc() ? e.length() : 0;
  EXPECT_NEAR(along_arcs, 4 * M_PI / 3, 1e-6);
}

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
