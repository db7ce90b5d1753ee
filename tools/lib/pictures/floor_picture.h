// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "picture.h"

#include <pcl/sedr_filters/floor_projection_recovery.h>

#include <pcl/point_types.h>

#include <vector>

namespace pcl::sedr::tools {

/** @brief Classification of the cells of a floor. */
struct FloorCells {
  double cell_size = 0; ///< metres
  CellSet seen;
  CellSet recovered; ///< below the ceiling, without a floor point
  CellSet removed;   ///< outside the room
};

/** @brief Returns the cells of the last run of a recovery that extracts removed
 * indices. */
FloorCells floorCellsOf(const pcl::FloorProjectionRecovery<pcl::PointXYZ>& recovery);

/** @brief Draws the result of FloorProjectionRecovery (paper, Figure 5): the floor
 * before, with hidden and outside cells, and after.
 * @param rooms one per run */
Picture drawFloor(const std::vector<FloorCells>& rooms);

} // namespace pcl::sedr::tools
