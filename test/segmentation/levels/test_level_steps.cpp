// SPDX-License-Identifier: BSD-3-Clause
#include "level_checks.h"

#include <algorithm>
#include <utility>

namespace {

using namespace sedr_test;

/** Levels of a turned room of 6 m x 5 m, whose ceiling is lower by `drop` beyond x =
 * `from`; four points per cell. */
std::vector<Level>
levelsOfAStep(double drop, double from, double noise)
{
  RoomPoints points(0.025, noise);
  PlanRoom room = roomOf(placed(rectangle(0, 0, 6, 5), 12, {0.01, 0.02}), 2.7);
  room.details = {
      detailOf(placed(rectangle(from, 0, 6, 5), 12, {0.01, 0.02}), 2.7 - drop)};
  points.room(room);
  return levelsOf(points);
}

TEST(LevelSteps, StandOutFromTheNoiseOfTheirPoints)
{
  // Equal halves and a strip; steps from within the noise to the tolerance.
  for (const double from : {3.0, 4.7})
    for (const double drop : {0.05, 0.08, 0.1}) {
      const auto levels = levelsOfAStep(drop, from, 0.02);
      ASSERT_EQ(kindsOf(levels), (std::vector<LevelKind>{Floor, Ceiling, Ceiling}))
          << drop << " from " << from;
      EXPECT_NEAR(levels[1].height, 2.7 - drop, 0.003);
      EXPECT_NEAR(levels[2].height, 2.7, 0.003);
      const double low = 5 * (6 - from);
      const double high = 5 * from;
      EXPECT_NEAR(static_cast<double>(levels[1].cells.size()) * 0.0025, low,
                  0.08 * low);
      EXPECT_NEAR(static_cast<double>(levels[2].cells.size()) * 0.0025, high,
                  0.08 * high);
    }
}

TEST(LevelSteps, NoiseAloneHasNone)
{
  for (const unsigned seed : {1u, 2u, 3u}) {
    RoomPoints points(0.05, 0.025, seed);
    points.room(rectangle(0, 0, 8, 6), 0, 2.7);
    expectHeights(levelsOf(points), {0, 2.7}, 0.002);
  }
}

TEST(LevelSteps, LowOnesPartRegionsThatTheyBoundButNotRoomsBeyondAWall)
{
  // 3 cm within a room, and between two rooms: real slabs are never quite equal.
  EXPECT_EQ(levelsOfAStep(0.03, 3.0, 0.002).size(), 3u);
  RoomPoints points(0.025, 0.002);
  points.room(rectangle(0, 0, 4, 4), 0, 2.7);
  points.room(rectangle(4.2, 0, 8.2, 4), 0, 2.73);
  EXPECT_EQ(levelsOf(points).size(), 2u);
}

TEST(LevelSteps, WhatNoiseBringsNearALevelStaysWithItsOwn)
{
  // Ten centimetres higher beyond a partition: half its points within the tolerance.
  RoomPoints points(0.025, 0.02);
  points.room(rectangle(0, 0, 5, 5), 0, 2.6);
  const RoomParts small = points.room(rectangle(5.1, 0, 6.9, 1.8), 0, 2.69);
  const auto levels = levelsOf(points);
  ASSERT_EQ(levels.size(), 3u);
  const auto inliers = levels[1].inliers;
  EXPECT_EQ(std::count_if(small.ceiling.begin(), small.ceiling.end(),
                          [&](int i) {
                            return std::binary_search(inliers.begin(), inliers.end(),
                                                      i);
                          }),
            0);
}

} // namespace
