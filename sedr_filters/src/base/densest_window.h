// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace pcl::sedr {

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
