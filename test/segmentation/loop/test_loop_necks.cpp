// SPDX-License-Identifier: BSD-3-Clause
#include "closed_loop.h"
#include "plan_loops.h"

#include "sedr_segmentation/src/loop/loop_necks.h"

#include <gtest/gtest.h>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

TEST(CutNecks, LeavesSmallStepsGroovesAndPartitionsAsTheyAre)
{
  const PlanLoop truth = polygon({{0, 0},
                                  {1, 0},
                                  {1.02, 0.03}, // a slanted step
                                  {2, 0.03},
                                  {2, -0.2}, // a groove of 6 cm
                                  {2.06, -0.2},
                                  {2.06, 0.03},
                                  {3, 0.03},
                                  {3, 1}, // a partition of 5 cm
                                  {3.05, 1},
                                  {3.05, 0.03},
                                  {4, 0.03},
                                  {4, 3},
                                  {0, 3}});
  PlanLoop loop = truth;
  EXPECT_EQ(cutNecks(loop), 0u);
  EXPECT_EQ(loop.elements.size(), truth.elements.size());
}

TEST(CutNecks, CutsSlitsSpikesAndPockets)
{
  PlanLoop loop = polygon({{0, 0},
                           {1, 0},
                           {1, -0.3}, // a slit of 3 cm
                           {1.03, -0.3},
                           {1.03, 0},
                           {4, 0},
                           {4, 3},
                           {2, 3},
                           {1.98, 3.3}, // a spike
                           {1.96, 3},
                           {1, 3},
                           {1, 3.02}, // a pocket behind a neck of 2 cm
                           {1.2, 3.1},
                           {0.9, 3.1},
                           {0.98, 3},
                           {0, 3}});
  EXPECT_EQ(cutNecks(loop), 3u);
  expectClosed(loop);
  EXPECT_NEAR(loop.area(), 12, 1e-3);
}

TEST(CutNecks, CutsWhatStandsOutTooThinForAWall)
{
  PlanLoop loop =
      polygon({{0, 0}, {2, 0}, {2.01, 0.3}, {2.03, 0}, {4, 0}, {4, 3}, {0, 3}});
  EXPECT_EQ(cutNecks(loop), 1u);
  expectClosed(loop);
  EXPECT_NEAR(loop.area(), 12, 1e-4);
}

TEST(CutNecks, LeavesRoomsThatANarrowWayJoins)
{
  // Two rooms with a slit of 3 cm between them: each is too large to be cut off.
  PlanLoop loop = polygon({{0, 0},
                           {2, 0},
                           {2, 1},
                           {2.1, 1},
                           {2.1, 0},
                           {4, 0},
                           {4, 2},
                           {2.1, 2},
                           {2.1, 1.03},
                           {2, 1.03},
                           {2, 2},
                           {0, 2}});
  EXPECT_EQ(cutNecks(loop), 0u);
  EXPECT_NEAR(loop.area(), 4 + 3.8 + 0.003, 1e-12);
}

TEST(CutNecks, LeavesARoundRoom)
{
  PlanLoop loop = circle({1, 1}, 2);
  EXPECT_EQ(cutNecks(loop), 0u);
}

} // namespace
