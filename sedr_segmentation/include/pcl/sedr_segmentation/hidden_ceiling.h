// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/cell_mask.h>
#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_segmentation/column_table.h>

namespace pcl {
namespace sedr {

/** @brief The cells of a room's ceiling along its walls that something below hides, a
 * duct or a cable tray, or that lie above it, in a slot for a curtain.
 *
 * There, the ceiling that was seen ends before the wall. The strip between the two is
 * the room's where a wall stands behind it along nearly all of its outer edge, none
 * before it, it is at most 0.6 m deep, and nothing closes it above as the lintel and
 * the top of a niche would. Above a window a wall is what rises 0.1 m above the
 * ceiling.
 *
 * @param room cells in which its ceilings were seen, in the box of `columns`
 * @param others cells of other rooms
 * O(cells of the box). */
CellMask hiddenCeiling(const CellMask& room,
                       const CellMask& others,
                       const CellGrid& grid,
                       const ColumnTable& columns,
                       const PlanSlab& ceiling,
                       const PlanSlab& floor);

} // namespace sedr
} // namespace pcl
