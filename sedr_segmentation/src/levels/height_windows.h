// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "horizontal_levels.h"

#include <cstddef>
#include <vector>

namespace pcl::sedr {

/** @brief A range [first, last) of candidates sorted by height, with its cell count. */
struct HeightWindow {
  std::size_t first = 0;
  std::size_t last = 0;
  std::size_t cells = 0;
};

/** @brief Returns the height window with the most occupied cells, the lowest among
 * equals; empty if none has more than `fewer`. `sorted` is sorted by height. O(n). */
HeightWindow densestWindow(const std::vector<Candidate>& sorted,
                           double height,
                           std::size_t cell_count,
                           std::size_t fewer);

/** @brief Counts the cells of candidates sorted by height, bin by bin. O(n). */
HeightHistogram histogramOf(const std::vector<Candidate>& sorted,
                            double bin_height,
                            std::size_t cell_count);

/** @brief Removes the candidates at `positions`, increasing. O(n). */
void erase(std::vector<Candidate>& candidates,
           const std::vector<std::size_t>& positions);

} // namespace pcl::sedr
