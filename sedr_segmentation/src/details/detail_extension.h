// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sedr_filters/src/grids/cell_mask.h"
#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/priors.h>

#include <cstdint>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Lets beams go on over what was not seen of them.
 *
 * A detail that is a straight strip, at least twice as long as wide, is followed beyond
 * both ends over cells without a height, at most half of its length. Where nothing of
 * the main slab was seen in its way until the room or another detail ends it, those
 * cells are its own; and what it meets, if that is the same strip at the same height,
 * behind a column or in its shadow, becomes a part of it.
 * @param room    cells of the room
 * @param details planes of the details, of labels 1, 2, ...
 * @param[in,out] label of every cell of the box: 0 the main slab, k the k-th detail, -1
 *   none. A detail that became a part of another keeps no cell.
 * O(cells) for each detail. */
void extendDetails(const CellMask& room,
                   const std::vector<PlanSlab>& details,
                   const CellGrid& grid,
                   std::vector<std::int32_t>& label,
                   const Priors& priors = {});

} // namespace sedr
} // namespace pcl
