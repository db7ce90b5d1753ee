// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan_walls.h"

#include <vector>

namespace pcl::sedr {

/** @brief The faces of a plan that are the two sides of one wall, and the others. */
struct FacePairs {
  std::vector<PlanWall> walls; ///< with both faces, without outlines
  std::vector<PlanWall> free;  ///< unpaired stretches, in the order of the faces
};

/** @brief Pairs faces, the nearest first. Cost: faces squared. */
FacePairs pairFaces(const Floorplan& plan, const WallParameters& parameters);

} // namespace pcl::sedr
