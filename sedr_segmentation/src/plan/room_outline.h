// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../profiles/ceiling_gap.h"
#include "../profiles/column_table.h"
#include "sedr_filters/src/grids/cell_mask.h"
#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/priors.h>

#include <vector>

namespace pcl::sedr {

/** @brief The cells of a room and of its columns. */
struct RoomOutline {
  CellMask room;                 ///< cells below its ceilings, with scan gaps closed
  std::vector<CellMask> columns; ///< holes with walls around from floor to ceiling
  double lost_area = 0; ///< of parts disconnected from the largest, square metres
};

/** @brief Finds the complete cells of a room and its columns.
 *
 * `seen` are the cells with a visible ceiling or detail. Notches and thin protrusions
 * without a wall along them are removed: there the ceiling was hidden, or seen through
 * an opening. Slits of a few cells are closed unless they are a partition, i.e. a wall
 * up to the ceiling that reaches well into the room. A hole with a wall up to the
 * ceiling around it is a column; other holes (lamps, cupboards, or both above each
 * other) are closed. If several parts cannot be joined, the largest is the room.
 *
 * @param seen its box must have a margin of at least 12 cells
 * @param columns profiles of all points around the room
 * @param ceiling,floor planes of the room
 * @param gap band below the ceiling's noise; objects without points there end below it
 */
RoomOutline outlineRoom(const CellMask& seen,
                        const CellGrid& grid,
                        const ColumnTable& columns,
                        const PlanSlab& ceiling,
                        const PlanSlab& floor,
                        const CeilingGap& gap = {},
                        const Priors& priors = {});

} // namespace pcl::sedr
