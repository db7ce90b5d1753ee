// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace pcl {
namespace sedr {

/** @brief The value at position n / 2 of n sorted values, n > 0: their median, of an
 * even number the upper one. None may be NaN. O(n): faster than std::nth_element()
 * where they are spread over a range, as distances are. */
double middleValue(std::vector<double> values);

} // namespace sedr
} // namespace pcl
