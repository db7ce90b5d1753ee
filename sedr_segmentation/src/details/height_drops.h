// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/cell_grid.h>
#include <pcl/sedr_filters/priors.h>

#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief Marks the cells of drops: the trimmed means of the heights of the four
 * cells on either side differ by at least 1.5 cm and clearly more than by noise. O(n).
 * @param heights of the cells, metres */
std::vector<std::uint8_t> cellsOfDrops(const CellSet& cells,
                                       const std::vector<double>& heights,
                                       const Priors& priors = {});

} // namespace pcl::sedr
