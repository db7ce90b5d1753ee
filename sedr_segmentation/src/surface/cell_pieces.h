// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sheet_grid.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief Connected cells of a set, eight neighbours each. */
std::vector<std::vector<std::size_t>> piecesOf(const SheetGrid& grid,
                                               const std::vector<std::uint8_t>& is_in);

/** @brief The cells of each label in parts that hang together by sides. O(n). */
std::vector<std::vector<std::size_t>> piecesOf(const SheetGrid& grid,
                                               const std::vector<std::int32_t>& label);

/** @brief Gives cells whose label is below 0 that of the nearest one with, by steps. */
void fillNearest(const SheetGrid& grid, std::vector<std::int32_t>& label);

} // namespace pcl::sedr
