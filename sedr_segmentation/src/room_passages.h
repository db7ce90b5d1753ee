// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/cell_mask.h>

namespace pcl {
namespace sedr {

/** @brief Where one ceiling goes on through openings as high as the rooms that they
 * join. */
struct CeilingPassages {
  CellMask cells;  ///< between the faces of the wall that the opening is in
  CellMask closed; ///< a neck more on both sides: what parts eroded ceilings
};

/** @brief The passages of a ceiling. Each is between two jambs, ends of walls as thick
 * as partitions are that face each other; a room that narrows has none.
 * @param core the ceiling, eroded by `neck` cells
 * O(cells of the box). */
CeilingPassages
passagesThrough(const CellMask& core, const CellGrid& grid, double neck);

} // namespace sedr
} // namespace pcl
