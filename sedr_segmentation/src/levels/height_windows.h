// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "horizontal_levels.h"

#include <cstddef>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief A stretch [first, last) of candidates sorted by height, and its number of
 * cells. */
struct HeightWindow {
  std::size_t first = 0;
  std::size_t last = 0;
  std::size_t cells = 0;
};

/** @brief The lowest of the windows of the given height that hold points in most cells,
 * in more than `fewer`, of candidates sorted by height; none where there is no such.
 * Cells are counted only where there are points enough. O(n). */
HeightWindow densestWindow(const std::vector<Candidate>& sorted,
                           double height,
                           std::size_t cell_count,
                           std::size_t fewer);

/** @brief Counts the cells of candidates sorted by height, bin by bin. O(n). */
HeightHistogram histogramOf(const std::vector<Candidate>& sorted,
                            double bin_height,
                            std::size_t cell_count);

/** @brief Takes `positions`, increasing, out of the candidates. O(n). */
void erase(std::vector<Candidate>& candidates,
           const std::vector<std::size_t>& positions);

} // namespace sedr
} // namespace pcl
