// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "picture.h"

#include "sedr_segmentation/src/plan/room_fit.h"

#include <vector>

namespace pcl::sedr::tools {

/** @brief Draws the result of FloorplanFitting (paper, Figure 7a): boundary points,
 * fitted lines and arcs, corners and rooms. */
Picture drawPlan(const Floorplan& plan, const std::vector<FittedBoundary>& boundaries);

} // namespace pcl::sedr::tools
