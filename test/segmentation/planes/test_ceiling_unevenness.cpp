// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/levels/level_checks.h"

#include <algorithm>
#include <cmath>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** A room of 8 m x 6 m whose ceiling at 2.5 m sags by `sag(x, y)` metres. */
template <typename Sag>
RoomPoints
roomWithCeiling(Sag sag)
{
  RoomPoints points(0.05, 0.002);
  points.slab(rectangle(0.01, 0.01, 8.01, 6.01), 0);
  for (double y = 0.035; y < 6; y += 0.05)
    for (double x = 0.035; x < 8; x += 0.05)
      points.point(x, y, 2.5 - sag(x, y));
  return points;
}

TEST(LevelSteps, WhatStandsOutAtOnceIsAStepAndLessThanOneAndAHalfCentimetresUnevenness)
{
  const auto levelsFor = [](double depth) {
    return levelsOf(
        roomWithCeiling([&](double x, double) { return x > 5.5 ? depth : 0; }));
  };
  expectHeights(levelsFor(0.04), {0, 2.46, 2.5}, 0.002);
  expectHeights(levelsFor(0.022), {0, 2.478, 2.5}, 0.002);
  EXPECT_EQ(levelsFor(0.012).size(), 2u);
}

TEST(LevelSteps, WhatLeavesThePlaneGraduallyIsUnevenness)
{
  // A drop-shaped bulge of 6 cm, 5 m wide: level around it and in its middle.
  const auto levels = levelsOf(roomWithCeiling([](double x, double y) {
    const double r = std::min(1.0, std::hypot(x - 4, y - 3) / 2.5);
    return 0.03 * (1 + std::cos(M_PI * r));
  }));
  EXPECT_EQ(levels.size(), 2u);
}

TEST(LevelSteps, WhatSlopesOrBendsHasNoStepHoweverSteepItIs)
{
  // Scallops 13 cm deep with slopes of a fifth; a ramp of 6 cm over 60 cm.
  const auto levels = levelsOf(
      roomWithCeiling([](double x, double) { return 0.065 * std::cos(M_PI * x); }));
  EXPECT_EQ(levels.size(), 2u);
  const auto of_ramp = levelsOf(roomWithCeiling(
      [](double x, double) { return std::clamp(0.1 * (x - 4), 0.0, 0.06); }));
  EXPECT_EQ(of_ramp.size(), 2u);
}

TEST(LevelSteps, PartALevelInWhateverDirectionTheyRun)
{
  for (const double degrees : {20.0, 45.0}) {
    const double c = std::cos(degrees * M_PI / 180);
    const double s = std::sin(degrees * M_PI / 180);
    const auto levels = levelsOf(roomWithCeiling([&](double x, double y) {
      return c * (x - 4.31) + s * (y - 3.31) > 0 ? 0.03 : 0;
    }));
    ASSERT_EQ(levels.size(), 3u) << degrees;
    EXPECT_NEAR(levels[1].height, 2.47, 0.002) << degrees;
    EXPECT_NEAR(levels[2].height, 2.5, 0.002) << degrees;
  }
}

} // namespace
