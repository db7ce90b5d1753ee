// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace pcl::sedr {

/** @brief Returns the median: the value at position n / 2 of n > 0 sorted values, the
 * upper one if n is even. NaN is not allowed. O(n). */
double middleValue(std::vector<double> values);

} // namespace pcl::sedr
