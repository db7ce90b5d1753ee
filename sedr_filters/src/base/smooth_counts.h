// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace pcl::sedr {

/** @brief Counts of values, smoothed by a Gaussian of height 1: where n values are the
 * same, the count is n. At least one value is needed. O(values + bins). */
struct SmoothCounts {
  double first = 0;
  double bin = 0;
  std::vector<double> counts;

  SmoothCounts(const std::vector<double>& values, double sigma)
      : bin(sigma / 4)
  {
    constexpr int reach = 12; // bins
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    first = *low - (reach + 1) * bin;
    std::vector<double> raw(
        static_cast<std::size_t>((*high - first) / bin) + 2 * reach + 2, 0);
    for (const double value : values) { // shared by the two bins around it
      const double at = (value - first) / bin;
      const auto k = static_cast<std::size_t>(at);
      raw[k] += 1 - (at - static_cast<double>(k));
      raw[k + 1] += at - static_cast<double>(k);
    }
    counts.assign(raw.size(), 0);
    for (std::size_t k = reach; k + reach < raw.size(); ++k)
      if (raw[k] > 0)
        for (int d = -reach; d <= reach; ++d)
          counts[k + static_cast<std::size_t>(d + reach) - reach] +=
              raw[k] * std::exp(-d * d / 32.0);
  }

  /** @brief Subtracts what there is around each of them, and what is below 0. */
  void keepPeaks()
  {
    constexpr int reach = 40; // bins
    const auto n = static_cast<int>(counts.size());
    std::vector<double> sums(counts.size() + 1, 0);
    std::partial_sum(counts.begin(), counts.end(), sums.begin() + 1);
    for (int k = 0; k < n; ++k) {
      const double around = sums[static_cast<std::size_t>(std::min(n, k + reach + 1))] -
                            sums[static_cast<std::size_t>(std::max(0, k - reach))];
      double& count = counts[static_cast<std::size_t>(k)];
      count = std::max(0.0, count - around / (2 * reach + 1));
    }
  }
};

} // namespace pcl::sedr
