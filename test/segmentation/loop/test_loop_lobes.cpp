// SPDX-License-Identifier: BSD-3-Clause
#include "closed_loop.h"
#include "plan_loops.h"

#include "sedr_segmentation/src/loop/loop_lobes.h"

#include <gtest/gtest.h>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

PlanLoop
loopOf(const Corners& corners)
{
  PlanLoop loop;
  for (std::size_t i = 0; i < corners.size(); ++i)
    loop.elements.push_back(segment(corners[i], corners[(i + 1) % corners.size()]));
  return loop;
}

TEST(CutLobes, LeavesALoopThatDoesNotCrossItselfAsItIs)
{
  PlanLoop loop = rectangle(0, 0, 4, 3);
  EXPECT_TRUE(cutLobes(loop));
  EXPECT_EQ(loop.elements.size(), 4u);
  EXPECT_DOUBLE_EQ(loop.area(), 12);
}

TEST(CutLobes, CutsCornersThatCameOutInTheWrongOrder)
{
  // The short piece at (4, 0) runs backwards: the walls cross at (3.9, 0).
  PlanLoop loop = loopOf({{0, 0}, {4, 0}, {3.8, -0.1}, {4, 0.1}, {4, 3}, {0, 3}});
  ASSERT_TRUE(cutLobes(loop));
  expectClosed(loop);
  ASSERT_EQ(loop.elements.size(), 5u);
  EXPECT_NEAR((loop.elements[0].end - Eigen::Vector2d(3.9, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR(loop.area(), 12 - 0.005, 1e-12);
}

TEST(CutLobes, CutsEveryLobe)
{
  PlanLoop loop = loopOf({{0, 0},
                          {4, 0},
                          {3.8, -0.1},
                          {4, 0.1},
                          {4, 3},
                          {0.2, 3},
                          {0, 3.2},
                          {0.1, 2.8},
                          {0.3, 3.3},
                          {0, 2.7}});
  ASSERT_TRUE(cutLobes(loop));
  expectClosed(loop);
  PlanLoop again = loop;
  ASSERT_TRUE(cutLobes(again));
  EXPECT_EQ(again.elements.size(), loop.elements.size());
  EXPECT_NEAR(loop.area(), 12, 0.2);
}

TEST(CutLobes, CutsAnArcOnItsCircle)
{
  // The wall at x = 4 continues to y = -0.5; the arc starts below it.
  PlanLoop loop;
  loop.elements = {segment({0, 0}, {4, 0}),       segment({4, 0}, {4, 3}),
                   arc({2, 3}, 2, 0, 180),        segment({0, 3}, {0, -0.5}),
                   segment({0, -0.5}, {-0.5, 0}), segment({-0.5, 0}, {0, 0})};
  ASSERT_TRUE(cutLobes(loop));
  expectClosed(loop);
  EXPECT_EQ(loop.elements.size(), 4u);
  EXPECT_NEAR(loop.area(), 12 + 2 * M_PI, 1e-9);
}

TEST(CutLobes, DoesNotCutAwayTheLoopItself)
{
  // A figure of eight: neither half is a lobe.
  const PlanLoop eight = loopOf({{0, 0}, {4, 3}, {4, 0}, {0, 3}});
  PlanLoop loop = eight;
  EXPECT_FALSE(cutLobes(loop));
  EXPECT_EQ(loop.elements.size(), 4u);
  EXPECT_EQ(loop.elements[1].end, eight.elements[1].end);
}

} // namespace
