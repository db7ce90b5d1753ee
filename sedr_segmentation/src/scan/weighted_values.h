// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace pcl::sedr {

/** @brief A number with a weight. */
struct Weighted {
  double value;
  double weight;

  bool operator<(const Weighted& other) const { return value < other.value; }
};

/** @brief An interval of numbers. */
struct Interval {
  double middle = 0;
  double width = 0;
};

/** @brief Returns the shortest interval with half of the weight (Rousseeuw 1984). */
Interval shortestHalf(std::vector<Weighted> values);

/** @brief Returns the weighted quantile: the smallest value with the given share of the
 * weight at or below it; 0 if empty. */
double quantileOf(std::vector<Weighted> values, double share);

/** @brief Returns the weighted median. */
double medianOf(std::vector<Weighted> values);

} // namespace pcl::sedr
