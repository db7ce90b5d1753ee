// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace pcl::sedr {

/** @brief Returns the median: the value at position n / 2 of n > 0 sorted values, the
 * upper one if n is even. NaN is not allowed. O(n). */
inline double
middleValue(std::vector<double> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/** @brief A number and its weight. */
using Weighted = std::pair<double, double>;

/** @brief Returns the smallest value with a share of the weight at or below it; 0 if
 * there is none. O(n log n). */
inline double
weightedQuantile(std::vector<Weighted> values, double share)
{
  std::sort(values.begin(), values.end());
  double total = 0;
  for (const Weighted& value : values)
    total += value.second;
  double sum = 0;
  for (const Weighted& value : values)
    if ((sum += value.second) >= share * total)
      return value.first;
  return 0;
}

/** @brief Returns the first and the last of the most of some sorted values that lie
 * within a width. Of windows with as many, the first. Values must not be empty. O(n).
 */
inline std::pair<std::size_t, std::size_t>
densestWindow(const std::vector<double>& sorted, double width)
{
  std::pair<std::size_t, std::size_t> best(0, 0);
  for (std::size_t first = 0, last = 0; last < sorted.size(); ++last) {
    while (sorted[last] - sorted[first] > width)
      ++first;
    if (last - first > best.second - best.first)
      best = {first, last};
  }
  return best;
}

} // namespace pcl::sedr
