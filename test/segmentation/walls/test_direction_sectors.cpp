// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/walls/direction_sectors.h"

#include "sedr_segmentation/src/walls/boundary_points.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace {

using namespace pcl::sedr;

std::uint64_t
sectorsOf(const std::vector<float>& directions)
{
  std::uint64_t seen = 0;
  for (const float d : directions)
    seen |= DirectionSectors::bitOf(std::cos(d), std::sin(d));
  return seen;
}

TEST(DirectionSectors, AgreeWithTheAnglesThemselves)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<float> anywhere(-3.14f, 3.14f);
  for (const float angle : {0.1f, 0.3f, 0.7854f, 1.0472f, 2.f, 4.f}) {
    const DirectionSectors sectors(angle);
    int told = 0;
    for (int trial = 0; trial < 4000; ++trial) {
      std::vector<float> directions(1 + trial % 150);
      for (float& d : directions)
        d = anywhere(random);
      const std::uint64_t seen = sectorsOf(directions);
      const Gap gap = sectors.gapOf(seen);
      const bool is_wide = widestGap(directions) > angle;
      EXPECT_TRUE(gap == Gap::Unknown || (gap == Gap::Wide) == is_wide) << angle;
      EXPECT_FALSE(sectors.areClose(seen) && is_wide) << angle;
      told += gap == Gap::Unknown ? 0 : 1;
    }
    EXPECT_GT(told, 2000) << angle;
  }
}

TEST(DirectionSectors, AreQuicklyCloseAllAroundWithGapsOfHalfTheAngle)
{
  for (const float angle : {0.7854f, 1.0472f, 2.f}) {
    std::vector<float> directions;
    for (float d = 0; d < 6.2832f; d += angle / 2)
      directions.push_back(d);
    const DirectionSectors sectors(angle);
    EXPECT_TRUE(sectors.areClose(sectorsOf(directions))) << angle;
    directions.erase(directions.begin() + 2, directions.begin() + 5);
    EXPECT_FALSE(sectors.areClose(sectorsOf(directions))) << angle;
  }
}

TEST(DirectionSectors, TellAGapThatLiesAcrossTheFirstDirection)
{
  const DirectionSectors sectors(static_cast<float>(M_PI / 3));
  std::vector<float> directions;
  for (float d = 0.7f; d < 5.6f; d += 0.05f)
    directions.push_back(d);
  EXPECT_EQ(sectors.gapOf(sectorsOf(directions)), Gap::Wide);
  for (const float d : {5.9f, 6.2f, 0.2f})
    directions.push_back(d);
  EXPECT_EQ(sectors.gapOf(sectorsOf(directions)), Gap::None);
}

TEST(DirectionSectors, SayNothingOfNoDirections)
{
  EXPECT_EQ(DirectionSectors(1).gapOf(0), Gap::Unknown);
  EXPECT_FALSE(DirectionSectors(1).areClose(0));
}

} // namespace
