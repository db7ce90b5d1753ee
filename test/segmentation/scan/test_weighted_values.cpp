// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/scan/weighted_values.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace pcl {
namespace sedr {
namespace {

/** Computes the same by sorting all values. */
double
sortedQuantile(std::vector<Weighted> values, double share)
{
  std::sort(values.begin(), values.end());
  double all = 0;
  for (const Weighted& v : values)
    all += v.weight;
  double sum = 0;
  for (const Weighted& v : values)
    if ((sum += v.weight) >= share * all)
      return v.value;
  return values.empty() ? 0 : values.back().value;
}

TEST(WeightedValues, QuantilesAreThoseOfTheSortedValues)
{
  std::mt19937 random(1);
  for (std::size_t n = 1; n < 60; ++n)
    for (const int kinds : {3, 1000}) { // number of different values
      std::vector<Weighted> values;
      for (std::size_t i = 0; i < n; ++i)
        values.push_back({static_cast<double>(random() % kinds),
                          static_cast<double>(1 + random() % 4)});
      for (const double share : {0.0, 0.1, 0.5, 0.9, 1.0})
        EXPECT_EQ(quantileOf(values, share), sortedQuantile(values, share))
            << n << " values, share " << share;
      EXPECT_EQ(medianOf(values), sortedQuantile(values, 0.5));
    }
}

TEST(WeightedValues, HeavyValuesCountForMore)
{
  EXPECT_EQ(medianOf({{1, 1}, {2, 1}, {9, 5}}), 9);
  EXPECT_EQ(medianOf({{9, 1}, {2, 1}, {1, 5}}), 1);
  EXPECT_EQ(quantileOf({{3, 1}, {1, 1}, {2, 1}, {4, 1}}, 0.75), 3);
}

TEST(WeightedValues, OfNoneTheQuantileIsZero)
{
  EXPECT_EQ(quantileOf({}, 0.5), 0);
}

} // namespace
} // namespace sedr
} // namespace pcl
