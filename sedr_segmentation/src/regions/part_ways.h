// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sedr_filters/src/grids/cell_mask.h"

#include <vector>

namespace pcl::sedr {

/** @brief Returns the cells of the shortest ways from the core of a region to its parts
 * that lie apart from it, as where a ceiling was hardly seen: to those parts that are
 * worth more than the cells of the way and its two sides cost.
 * @param core one box with the region, as the other masks
 * @param free cells through which a way may lead
 * @param worth of each cell: below 0 if it costs something to take it
 * @param border what a border of one cell costs. O(cells log cells) a part. */
CellMask waysToParts(const CellMask& region,
                     const CellMask& core,
                     const CellMask& free,
                     const std::vector<float>& worth,
                     double border);

} // namespace pcl::sedr
