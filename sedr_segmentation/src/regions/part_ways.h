// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sedr_filters/src/grids/cell_mask.h"

namespace pcl::sedr {

/** @brief Returns the cells of the shortest ways from the core of a region to its parts
 * that lie apart, as where a ceiling was hardly seen: to parts that are worth more than
 * both sides of a way. Masks have one box.
 * @param air cells, each worth as much as a border of `worth` cells
 * @param free cells through which a way may lead. O(cells) a part. */
CellMask waysToParts(const CellMask& region,
                     const CellMask& core,
                     const CellMask& air,
                     const CellMask& free,
                     double worth);

} // namespace pcl::sedr
