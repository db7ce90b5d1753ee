// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

namespace pcl::sedr {

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

} // namespace pcl::sedr
