// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_filters/src/grids/digit_sort.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace {

using pcl::sedr::orderOf;
using Value = std::pair<std::uint32_t, int>; // sorting key and original position

std::uint32_t
keyOf(const Value& value)
{
  return value.first;
}

/** @brief Returns keys of the given number of low bits with their positions. */
std::vector<Value>
valuesOf(int n, unsigned bits)
{
  std::mt19937 random(1);
  std::vector<Value> values;
  for (int k = 0; k < n; ++k)
    values.emplace_back(random() >> (32 - bits), k);
  return values;
}

TEST(SortByDigits, SortsByAllBitsAndLeavesEqualValuesAsTheyStand)
{
  for (const int n : {0, 1, 2, 7, 5000})
    for (const unsigned bits : {1u, 8u, 11u, 12u, 22u, 23u, 32u}) {
      std::vector<Value> values = valuesOf(n, bits);
      std::vector<Value> sorted = values;
      std::sort(sorted.begin(), sorted.end());
      pcl::sedr::sortByDigits(values, keyOf);
      EXPECT_EQ(values, sorted) << n << " keys of " << bits << " bits";
    }
}

TEST(SortByDigits, PassesOverADigitThatAllShareOnly)
{
  std::vector<Value> values;
  for (int k = 0; k < 100; ++k)
    values.emplace_back(static_cast<std::uint32_t>(100 - k) << 22 | 0x155u << 11, k);
  std::vector<Value> sorted = values;
  std::sort(sorted.begin(), sorted.end());
  pcl::sedr::sortByDigits(values, keyOf);
  EXPECT_EQ(values, sorted);
}

TEST(OrderOf, RisesWithTheNumber)
{
  constexpr float least = std::numeric_limits<float>::denorm_min();
  const std::vector<float> rising{-1e30f, -2,     -1.5f, -1e-20f,  -least, 0,
                                  least,  1e-20f, 1,     1.00001f, 3e30f};
  for (std::size_t k = 1; k < rising.size(); ++k)
    EXPECT_LT(orderOf(rising[k - 1]), orderOf(rising[k])) << rising[k];
  EXPECT_EQ(orderOf(-0.0f), orderOf(0.0f));
}

} // namespace
