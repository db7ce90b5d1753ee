// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
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

} // namespace pcl::sedr
