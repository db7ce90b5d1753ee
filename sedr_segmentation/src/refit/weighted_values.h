// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace pcl {
namespace sedr {

/** @brief A number that counts. */
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

/** @brief The shortest interval that holds half of the weight (Rousseeuw 1984). */
Interval shortestHalf(std::vector<Weighted> values);

/** @brief The smallest value that has so large a share of the weight at or below it; 0
 * of none. */
double quantileOf(std::vector<Weighted> values, double share);

/** @brief The same for half of the weight. */
double medianOf(std::vector<Weighted> values);

} // namespace sedr
} // namespace pcl
