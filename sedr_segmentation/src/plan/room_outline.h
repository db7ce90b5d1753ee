// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../profiles/ceiling_gap.h"
#include "../profiles/column_table.h"
#include "sedr_filters/src/grids/cell_mask.h"
#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/priors.h>

#include <vector>

namespace pcl {
namespace sedr {

/** @brief The cells of a room, and of the columns that stand in it. */
struct RoomOutline {
  CellMask room; ///< what lies below its ceilings, gaps of the scan closed
  std::vector<CellMask>
      columns;          ///< holes of the room with a wall around, floor to ceiling
  double lost_area = 0; ///< of the parts that are far from the largest, square metres
};

/** @brief Makes a room's cells whole.
 *
 * `seen` are the cells in which a ceiling or a detail was seen. Notches of its outline
 * are closed and thin protrusions cut off where no wall stands along them: there,
 * something hid the ceiling, or it was seen through an opening. Slits of a few cells
 * are closed, too, unless they are a partition: a wall up to the ceiling that reaches
 * well into the room. Holes are closed unless a wall goes up to the ceiling around
 * them: such a hole is a column; a lamp, a cupboard, and the one above the other are
 * not. Of several parts too far from each other to be joined the largest is the room.
 *
 * @param seen in a box with a margin of at least 12 cells
 * @param columns all points around the room
 * @param ceiling,floor planes of the room
 * @param gap what is below the ceiling's noise: what has no point there ends short of
 * it */
RoomOutline outlineRoom(const CellMask& seen,
                        const CellGrid& grid,
                        const ColumnTable& columns,
                        const PlanSlab& ceiling,
                        const PlanSlab& floor,
                        const CeilingGap& gap = {},
                        const Priors& priors = {});

} // namespace sedr
} // namespace pcl
