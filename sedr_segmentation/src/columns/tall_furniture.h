// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../profiles/ceiling_gap.h"
#include "../profiles/column_table.h"
#include "sedr_filters/src/grids/cell_mask.h"
#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/priors.h>

namespace pcl {
namespace sedr {

/** @brief The cells of a box in which something stands, or hangs, in the upper half of
 * a room. O(cells of the box).
 * @param columns all points around the room
 * @param ceiling,floor planes of the room
 * @param threads 0: as many as there are processors */
CellMask uprightCells(const CellBox& box,
                      const CellGrid& grid,
                      const ColumnTable& columns,
                      const PlanSlab& ceiling,
                      const PlanSlab& floor,
                      unsigned threads);

/** @brief The cells of what stands, or hangs, in the upper half of a room and stops
 * short of its ceiling: wardrobes, cupboards and dividers, however small the gap above
 * them, screens, lamps.
 *
 * A wall ends what is seen of a ceiling. So of something upright that has no point in
 * `gap`, and above and around half of which the ceiling was seen, is known that it is
 * no wall; of a wall whose top is hidden it is not. O(cells of the box).
 * @param seen cells in which ceilings and soffits of the room were seen
 * @param upright uprightCells() of the same box
 * @param columns all points around the room
 * @param ceiling,floor planes of the room
 * @param gap what is below the ceiling's noise */
CellMask tallFurniture(const CellMask& seen,
                       const CellMask& upright,
                       const CellGrid& grid,
                       const ColumnTable& columns,
                       const PlanSlab& ceiling,
                       const PlanSlab& floor,
                       const CeilingGap& gap);

/** @brief Places smaller than a room, up to 1 m2, of whose ceiling three tenths and
 * more were seen, and what stands in the upper half of the room all around them, with
 * it: nobody sees the ceiling within a column; over a cabinet one does, whatever noise
 * says of how high that is. O(cells of the box).
 * @param seen cells in which ceilings and soffits of the room were seen
 * @param upright uprightCells() of the same box */
CellMask aroundSeenCeiling(const CellMask& seen,
                           const CellMask& upright,
                           const CellGrid& grid,
                           const Priors& priors = {});

} // namespace sedr
} // namespace pcl
