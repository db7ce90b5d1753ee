// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "picture.h"

#include "sedr_segmentation/src/plan/room_fit.h"

#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief Draws the result of FloorplanFitting (paper, Figure 7a): boundary points,
 * fitted lines and arcs, corners and rooms. */
Picture drawPlan(const Floorplan& plan, const std::vector<FittedBoundary>& boundaries);

} // namespace tools
} // namespace sedr
} // namespace pcl
