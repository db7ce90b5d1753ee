// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/levels/relief_window.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace pcl {
namespace sedr {
namespace {

TEST(ReliefWindow, TheMiddleMeanLiesInTheRangeThatIsToldWithoutSorting)
{
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0, 0.01);
  for (int trial = 0; trial < 2000; ++trial) {
    ReliefWindow window;
    const int count = 1 + static_cast<int>(random() % 25);
    const double step = trial % 2 == 0 ? 0 : 0.05;
    for (int i = 0; i < count; ++i)
      window.add(noise(random) + (random() % 3 == 0 ? step : 0));
    const auto [low, high] = window.middleRange();
    const double mean = window.middleMean();
    EXPECT_LE(low, mean);
    EXPECT_GE(high, mean);
  }
}

TEST(ReliefWindow, OfEqualValuesTheRangeIsNarrowAndWhatIsUnknownIsLeftOut)
{
  ReliefWindow window;
  for (int i = 0; i < 20; ++i)
    window.add(0.03);
  window.add(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(window.size(), 20u);
  EXPECT_NEAR(window.middleRange().first, 0.03, 1e-6);
  EXPECT_NEAR(window.middleRange().second, 0.03, 1e-6);
}

} // namespace
} // namespace sedr
} // namespace pcl
