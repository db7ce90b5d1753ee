// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../profiles/column_table.h"
#include "sedr_filters/src/grids/cell_mask.h"
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_segmentation/floorplan_fitting.h>

#include <vector>

namespace pcl::sedr {

/** @brief Points for the details of a ceiling or a floor: indices into the points. */
struct SlabEvidence {
  std::vector<int> main;    ///< of the main ceiling or floor
  std::vector<int> details; ///< of its parts at other heights, including risers
  bool is_floor = false;
};

/** @brief Fits the details of the ceiling or the floor of a room with known walls.
 *
 * The levels of the detail points give the heights. Unseen cells take the height of the
 * nearest seen cell. Each connected region becomes a detail with a plane and a loop.
 * Edges of the loop are the room's walls where they meet, else lines or arcs through
 * the points of risers. Largest first.
 *
 * @param room with boundary, columns, floor and ceiling
 * @param cells the cells of the room
 * @param columns profiles of all points in and near the room, in a box around the cells
 */
std::vector<PlanDetail> fitDetails(const PointView& points,
                                   const SlabEvidence& evidence,
                                   const PlanRoom& room,
                                   const CellMask& cells,
                                   const ColumnTable& columns,
                                   const RoomFitParameters& parameters);

} // namespace pcl::sedr
