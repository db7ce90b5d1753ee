// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace pcl::sedr {

/** @brief A value that was measured, and the variance of its error. */
struct MeasuredValue {
  double value = 0;
  double variance = 0;
};

/** @brief Finds which of some values are one, such as the directions of walls or the
 * heights of floors: the grouping that makes the values most probable, if a group's
 * value lies anywhere in an interval, and a value is as probable as it is frequent
 * (Chinese restaurant process). Values join the group that gains most by them, in the
 * given order, then groups join while that gains. O(values x groups + groups^3).
 * @param interval of the values
 * @param period of the values; 0: none
 * @return of each value the index of the first of its group */
std::vector<std::size_t>
shareValues(const std::vector<MeasuredValue>& values, double interval, double period);

} // namespace pcl::sedr
