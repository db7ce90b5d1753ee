// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../profiles/column_table.h"
#include "../sheets/sheet_fit.h"
#include "sedr_filters/src/grids/cell_mask.h"
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_segmentation/floorplan_fitting.h>

#include <vector>

namespace pcl::sedr {

/** @brief The ceiling or the floor of a room: its points, and what they were labelled
 * as. */
struct SlabEvidence {
  std::vector<int> indices; ///< of its points, whatever their height
  FacetSheet surface;       ///< see surfaceWithin()
  bool is_floor = false;
};

/** @brief Returns the plane of the largest facet, fitted to its points; of all points
 * if there is no facet. */
PlanSlab mainSlab(const PointView& points,
                  const SlabEvidence& evidence,
                  const RoomFitParameters& parameters);

/** @brief Fits the details of the ceiling or the floor of a room with known walls.
 *
 * Pieces of facets give the heights. Unseen cells take the height of the
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
