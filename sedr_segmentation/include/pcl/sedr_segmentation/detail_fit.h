// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/cell_mask.h>
#include <pcl/sedr_segmentation/room_fit.h>

#include <vector>

namespace pcl {
namespace sedr {

/** @brief Fits the details of a room whose walls are known.
 *
 * The levels of the detail points give the undersides; cells of the room in which
 * neither ceiling nor underside was seen go to the nearest one, so that every cell has
 * a height. Each connected underside becomes a detail: its plane, and a loop whose
 * edges are the room's walls where it meets them and lines or arcs through the risers'
 * points elsewhere. Largest first.
 *
 * @param room with boundary, columns, floor and ceiling
 * @param cells the cells of the room */
std::vector<PlanDetail> fitDetails(const PointView& points,
                                   const RoomEvidence& evidence,
                                   const PlanRoom& room,
                                   const CellMask& cells,
                                   const RoomFitParameters& parameters);

} // namespace sedr
} // namespace pcl
