// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../curves/plan_points.h"
#include "sedr_filters/src/grids/cell_mask.h"
#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_segmentation/floorplan_fitting.h>

#include <vector>

namespace pcl::sedr {

/** @brief The loops around a detail. */
struct DetailOutline {
  PlanLoop boundary;           ///< counter-clockwise; empty if there is none
  std::vector<PlanLoop> holes; ///< clockwise
};

/** @brief Fits loops to the contours of the largest region of some cells, and of its
 * holes of the minimum area of a detail, by LoopEnergy.
 * @param seen those of the cells that were seen; others are cut off cheaply
 * @param edges points of risers and walls, in plan
 * @param known elements of walls and of other details: to follow them costs nothing */
DetailOutline outlineOf(const CellMask& cells,
                        const CellMask& seen,
                        const PlanPoints& edges,
                        const std::vector<PlanElement>& known,
                        const RoomFitParameters& parameters);

} // namespace pcl::sedr
