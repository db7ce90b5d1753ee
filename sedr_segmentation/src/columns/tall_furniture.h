// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../profiles/ceiling_gap.h"
#include "../profiles/column_table.h"
#include "sedr_filters/src/grids/cell_mask.h"
#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/priors.h>

namespace pcl::sedr {

/** @brief Returns the cells of a box with an object in the upper half of a room.
 * O(cells of the box).
 * @param columns profiles of all points around the room
 * @param ceiling,floor planes of the room
 * @param threads 0: all processors */
CellMask verticalCells(const CellBox& box,
                       const CellGrid& grid,
                       const ColumnTable& columns,
                       const PlanSlab& ceiling,
                       const PlanSlab& floor,
                       unsigned threads);

/** @brief Returns the cells of objects in the upper half of a room that do not reach
 * its ceiling: wardrobes, cupboards and dividers with any gap above, screens, lamps.
 *
 * The visible ceiling ends at a wall. A vertical object without points in `gap`, with
 * the ceiling seen above and around half of it, is therefore no wall. This does not
 * hold for a wall with a hidden top. O(cells of the box).
 * @param seen cells in which ceilings and soffits of the room were seen
 * @param vertical verticalCells() of the same box
 * @param columns profiles of all points around the room
 * @param ceiling,floor planes of the room
 * @param gap the band just below the ceiling's noise */
CellMask tallFurniture(const CellMask& seen,
                       const CellMask& vertical,
                       const CellGrid& grid,
                       const ColumnTable& columns,
                       const PlanSlab& ceiling,
                       const PlanSlab& floor,
                       const CeilingGap& gap);

/** @brief Returns enclosed areas up to 1 m2 with at least three tenths of their ceiling
 * seen, and the vertical objects around them. The ceiling is visible above a cabinet,
 * whatever its height, but not within a column. O(cells of the box).
 * @param seen cells in which ceilings and soffits of the room were seen
 * @param vertical verticalCells() of the same box */
CellMask aroundSeenCeiling(const CellMask& seen,
                           const CellMask& vertical,
                           const CellGrid& grid,
                           const Priors& priors = {});

} // namespace pcl::sedr
