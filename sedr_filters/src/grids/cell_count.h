// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

/** @brief Returns the number of cells of a length, rounded, at least `least`. Lengths
 * in metres thus hold for any cell size. */
inline int
cellsFor(double metres, double cell_size, int least = 1)
{
  return std::max(least, static_cast<int>(std::lround(metres / cell_size)));
}

} // namespace pcl::sedr
