// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/loop/loop_bumps.h"

#include "closed_loop.h"
#include "plan_loops.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

constexpr double narrowest = 0.2; // metres

/** A room of 4 m x 3 m with a bump on the wall y = 0. */
PlanLoop
roomWith(const Corners& bump)
{
  Corners corners{{0, 0}};
  corners.insert(corners.end(), bump.begin(), bump.end());
  corners.insert(corners.end(), {{4, bump.back().y()}, {4, 3}, {0, 3}});
  return polygon(corners);
}

TEST(LoopBumps, AWallGoesStraightOnWhereItComesBackAtOnce)
{
  for (const double side : {-1.0, 1.0}) {
    PlanLoop loop =
        roomWith({{2, 0}, {1.95, 0.1 * side}, {2.1, 0.12 * side}, {2.1, 0}});
    loop.elements[0].inliers = 100;
    loop.elements[4].inliers = 50;
    EXPECT_EQ(dropBumps(loop, narrowest), 1) << side;
    expectClosed(loop);
    ASSERT_EQ(loop.elements.size(), 4u);
    EXPECT_NEAR(loop.area(), 12, 1e-9);
    EXPECT_EQ(loop.elements[0].inliers, 150u);
  }
}

TEST(LoopBumps, BetweenTwoWallsAStepIsLeftAtTheSquarerEnd)
{
  PlanLoop loop = roomWith({{2, 0}, {1.9, 0.1}, {2.05, 0.1}, {2.05, -0.05}});
  EXPECT_EQ(dropBumps(loop, narrowest), 1);
  expectClosed(loop);
  EXPECT_EQ(loop.elements.size(), 6u);
  EXPECT_NEAR(loop.area(), 12 + 1.95 * 0.05, 1e-9);

  loop = roomWith({{2, 0}, {2, 0.1}, {2.15, 0.1}, {2.05, -0.05}});
  EXPECT_EQ(dropBumps(loop, narrowest), 1);
  expectClosed(loop);
  EXPECT_NEAR(loop.area(), 12 + 2 * 0.05, 1e-9);
}

TEST(LoopBumps, SeveralInARowAreDropped)
{
  PlanLoop loop = roomWith({{1, 0},
                            {1.05, 0.1},
                            {1.1, 0},
                            {2, 0},
                            {2.05, 0.1},
                            {2.1, 0},
                            {3, 0},
                            {3.05, -0.1},
                            {3.1, 0}});
  EXPECT_EQ(dropBumps(loop, narrowest), 3);
  expectClosed(loop);
  EXPECT_EQ(loop.elements.size(), 4u);
}

TEST(LoopBumps, PilastersGroovesStepsAndWhatIsLargerStay)
{
  const Corners pilaster{{2, 0}, {2, 0.1}, {2.1, 0.1}, {2.1, 0}};
  const Corners groove{{2, 0}, {2, -0.15}, {2.05, -0.15}, {2.05, 0}};
  const Corners step{{2, 0}, {2.02, 0.05}};
  const Corners wide{{2, 0}, {2.05, 0.1}, {2.2, 0.1}, {2.25, 0}};
  const Corners partition{{2, 0}, {2.1, 0.5}, {2.15, 0.5}, {2.05, 0}};
  for (const Corners& kept : {pilaster, groove, step, wide, partition}) {
    const PlanLoop truth = roomWith(kept);
    PlanLoop loop = truth;
    EXPECT_EQ(dropBumps(loop, narrowest), 0) << kept[1].transpose();
    EXPECT_EQ(loop.elements.size(), truth.elements.size());
  }
}

TEST(LoopBumps, ArePartedFromSquareOnesByTenDegrees)
{
  for (const double degrees : {8.0, 12.0}) {
    const double slant = 0.1 * std::tan(degrees * M_PI / 180);
    PlanLoop loop = roomWith({{2, 0}, {2 + slant, 0.1}, {2.15, 0.1}, {2.15, 0}});
    EXPECT_EQ(dropBumps(loop, narrowest), degrees > 10 ? 1 : 0) << degrees;
    const double rise = 0.15 * std::tan(degrees * M_PI / 180); // along the wall
    PlanLoop along = roomWith({{2, 0}, {2, 0.1}, {2.15, 0.1 + rise}, {2.15, 0}});
    EXPECT_EQ(dropBumps(along, narrowest), degrees > 10 ? 1 : 0) << degrees;
  }
}

TEST(LoopBumps, AreNarrowAlongTheWallAndAcross)
{
  for (const double size : {0.19, 0.21}) {
    const int expected = size < narrowest ? 1 : 0;
    for (const double side : {-1.0, 1.0}) {
      PlanLoop wide = roomWith({{2, 0}, {2.03, 0.05 * side}, {2 + size, 0}});
      EXPECT_EQ(dropBumps(wide, narrowest), expected) << size;
      PlanLoop deep = roomWith({{2, 0}, {2.05, size * side}, {2.1, 0}});
      EXPECT_EQ(dropBumps(deep, narrowest), expected) << size;
    }
    // Both walls are at least as long as a bump is wide.
    PlanLoop short_wall = polygon({{0, 0},
                                   {2, 0},
                                   {2.03, 0.05},
                                   {2.06, 0},
                                   {2.06 + size, 0},
                                   {2.06 + size, 3},
                                   {0, 3}});
    EXPECT_EQ(dropBumps(short_wall, narrowest), 1 - expected) << size;
  }
}

TEST(LoopBumps, HaveSixSidesAtMost)
{
  for (const std::size_t sides : {6u, 7u}) {
    Corners zigzag{{2, 0}};
    for (std::size_t k = 1; k < sides; ++k)
      zigzag.emplace_back(2 + 0.02 * static_cast<double>(k), k % 2 == 1 ? 0.05 : 0.02);
    zigzag.emplace_back(2.15, 0);
    PlanLoop loop = roomWith(zigzag);
    EXPECT_EQ(dropBumps(loop, narrowest), sides == 6 ? 1 : 0) << sides;
  }
}

TEST(LoopBumps, WallsThatTurnByLessThanFiveDegreesAreOne)
{
  // Behind the bump the wall is offset by 3 cm and continues at an angle. Either one
  // wall with a step remains, or two walls meet.
  for (const double degrees : {4.0, 6.0}) {
    const double rise = 2 * std::tan(degrees * M_PI / 180);
    PlanLoop loop = polygon(
        {{0, 0}, {2, 0}, {1.97, 0.06}, {2.02, 0.03}, {4, 0.03 + rise}, {4, 3}, {0, 3}});
    ASSERT_EQ(dropBumps(loop, narrowest), degrees < 5 ? 1 : 0) << degrees;
  }
}

TEST(LoopBumps, WallsMeetInTheirCorner)
{
  const PlanLoop past =
      polygon({{0, 0}, {3.9, 0}, {4, -0.05}, {4.05, 0.1}, {4, 0.12}, {4, 3}, {0, 3}});
  const PlanLoop before =
      polygon({{0, 0}, {3.9, 0}, {3.85, 0.1}, {4, 0.15}, {4, 3}, {0, 3}});
  for (PlanLoop loop : {past, before}) {
    EXPECT_EQ(dropBumps(loop, narrowest), 1);
    expectClosed(loop);
    EXPECT_EQ(loop.elements.size(), 4u);
    EXPECT_NEAR(loop.area(), 12, 1e-9);
  }
}

TEST(LoopBumps, NoWallIsTurnedRound)
{
  // The walls would meet beyond the end of the second.
  PlanLoop loop = polygon({{0, 0},
                           {3, 0},
                           {2.97, -0.06},
                           {2.99, -0.17},
                           {3.135, -0.025},
                           {4, -0.02},
                           {4, 3},
                           {0, 3}});
  dropBumps(loop, narrowest);
  expectClosed(loop);
  for (std::size_t i = 0; i + 1 < loop.elements.size(); ++i) {
    const auto way = [&](std::size_t k) -> Eigen::Vector2d {
      return (loop.elements[k].end - loop.elements[k].start).normalized();
    };
    EXPECT_GT(way(i).dot(way(i + 1)), -0.9) << i;
  }
}

TEST(LoopBumps, ChamfersBoxesEndsOfPartitionsAndRoundWallsAreNone)
{
  const PlanLoop chamfer = polygon({{0, 0}, {3.9, 0}, {4, 0.1}, {4, 3}, {0, 3}});
  const PlanLoop box =
      polygon({{0, 0}, {3.9, 0}, {3.9, 0.1}, {4, 0.1}, {4, 3}, {0, 3}});
  const PlanLoop partition = polygon({{0, 0},
                                      {2, 0},
                                      {3, 1},
                                      {3.1, 1.05},
                                      {3.05, 0.95},
                                      {2.1, 0},
                                      {4, 0},
                                      {4, 3},
                                      {0, 3}});
  for (const PlanLoop& truth : {chamfer, box, partition, circle({0, 0}, 2)}) {
    PlanLoop loop = truth;
    EXPECT_EQ(dropBumps(loop, narrowest), 0);
    EXPECT_EQ(loop.elements.size(), truth.elements.size());
  }
}

} // namespace
