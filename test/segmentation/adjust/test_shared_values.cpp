// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/adjust/shared_values.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

namespace pcl::sedr {
namespace {

std::size_t
groupsOf(const std::vector<MeasuredValue>& values, double interval, double period)
{
  const std::vector<std::size_t> first = shareValues(values, interval, period);
  return std::set<std::size_t>(first.begin(), first.end()).size();
}

TEST(SharedValues, AreOneWhereverTheFirstOfThemLie)
{
  // Two exact values, 5 standard deviations apart, would part 60 others.
  std::mt19937 random(1);
  for (int k = 0; k < 50; ++k) {
    std::normal_distribution<double> error(0, 0.01);
    std::vector<MeasuredValue> values{{-0.014, 3e-5}, {0.014, 3e-5}};
    for (int i = 0; i < 60; ++i)
      values.push_back({error(random), 1e-4});
    EXPECT_EQ(groupsOf(values, M_PI / 2, M_PI / 2), 1u) << k;
  }
}

TEST(SharedValues, MayBeNoneOrOne)
{
  EXPECT_TRUE(shareValues({}, 1, 0).empty());
  EXPECT_EQ(shareValues({{3, 1}}, 1, 0), std::vector<std::size_t>{0});
}

} // namespace
} // namespace pcl::sedr
