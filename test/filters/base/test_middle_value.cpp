// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_filters/src/base/middle_value.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

namespace {

using pcl::sedr::middleValue;

double
sortedMiddle(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

TEST(MiddleValue, isTheUpperMiddleOfFewValues)
{
  EXPECT_EQ(middleValue({3}), 3);
  EXPECT_EQ(middleValue({4, 1}), 4);
  EXPECT_EQ(middleValue({9, -2, 5}), 5);
  EXPECT_EQ(middleValue({1, 2, 3, 4}), 3);
}

TEST(MiddleValue, isThatOfSortedValuesHoweverTheyAreSpread)
{
  std::mt19937 random(5);
  std::normal_distribution<double> normal(0, 0.01);
  std::vector<double> even;
  std::vector<double> lumped; // nearly all in one of many bins
  std::vector<double> skewed;
  for (int i = 0; i < 20001; ++i) {
    even.push_back(std::abs(normal(random)));
    lumped.push_back(i == 0 ? 1e6 : normal(random));
    skewed.push_back(std::exp(1000 * normal(random)));
  }
  for (auto values : {even, lumped, skewed})
    for (const std::size_t some : {20001, 400, 65, 64, 20}) {
      values.resize(some);
      EXPECT_EQ(middleValue(values), sortedMiddle(values)) << some;
    }
}

TEST(MiddleValue, isFoundAmongEqualAndInfiniteValues)
{
  std::vector<double> values(10000, 0.25);
  EXPECT_EQ(middleValue(values), 0.25);
  values[17] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(middleValue(values), 0.25);
  values[18] = std::nextafter(0.25, 0);
  EXPECT_EQ(middleValue(values), 0.25);
}

} // namespace
