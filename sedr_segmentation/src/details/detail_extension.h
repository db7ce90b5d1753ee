// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sedr_filters/src/grids/cell_mask.h"
#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/priors.h>

#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief Extends beams over their hidden parts.
 *
 * A beam is a straight strip at least twice as long as wide. It is extended beyond both
 * ends over cells without a height, by at most half of its length. The extension is
 * accepted if it meets the end of the room or another detail before any cell of the
 * main slab. A detail that continues the strip at the same height, e.g. behind a
 * column, is merged with it.
 * @param room    cells of the room
 * @param details planes of the details with labels 1, 2, ...
 * @param[in,out] label label of every cell of the box: 0 the main slab, k the k-th
 * detail, -1 none. A merged detail keeps no cell. O(cells) per detail. */
void extendDetails(const CellMask& room,
                   const std::vector<PlanSlab>& details,
                   const CellGrid& grid,
                   std::vector<std::int32_t>& label,
                   const Priors& priors = {});

} // namespace pcl::sedr
