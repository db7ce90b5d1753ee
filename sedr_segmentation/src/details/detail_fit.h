// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../plan/room_fit.h"
#include "../profiles/column_table.h"
#include "sedr_filters/src/grids/cell_mask.h"

#include <vector>

namespace pcl {
namespace sedr {

/** @brief What the details of a ceiling or of a floor are fitted to: indices into the
 * points. */
struct SlabEvidence {
  std::vector<int> main;    ///< of the main ceiling or floor
  std::vector<int> details; ///< of its parts at heights of their own, risers included
  bool is_floor = false;
};

/** @brief Fits the details of the ceiling, or of the floor, of a room whose walls are
 * known.
 *
 * The levels of the detail points give their heights; cells of the room in which
 * neither the main slab nor a detail was seen go to the nearest one, so that every cell
 * has a height. Each connected part becomes a detail: its plane, and a loop whose edges
 * are the room's walls where it meets them and lines or arcs through the risers' points
 * elsewhere. Largest first.
 *
 * @param room with boundary, columns, floor and ceiling
 * @param cells the cells of the room
 * @param columns all points of the room and near it, in a box around the cells */
std::vector<PlanDetail> fitDetails(const PointView& points,
                                   const SlabEvidence& evidence,
                                   const PlanRoom& room,
                                   const CellMask& cells,
                                   const ColumnTable& columns,
                                   const RoomFitParameters& parameters);

} // namespace sedr
} // namespace pcl
