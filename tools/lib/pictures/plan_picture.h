// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "picture.h"

#include "sedr_segmentation/src/plan/room_fit.h"

#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief What FloorplanFitting decided (paper, Figure 7a): the boundary points, and
 * the lines and arcs fitted to them, with corners and rooms. */
Picture drawPlan(const Floorplan& plan, const std::vector<FittedBoundary>& boundaries);

} // namespace tools
} // namespace sedr
} // namespace pcl
