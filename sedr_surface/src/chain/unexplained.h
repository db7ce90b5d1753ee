// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/plan_warning.h>
#include <pcl/sedr_segmentation/building.h>

#include <vector>

namespace pcl::sedr {

/** @brief Returns what of the floors and ceilings that were seen the plan does not
 * explain: connected places of 0.25 m2 and more that lie more than 10 cm off the model,
 * if they make up 2 % of a room; one warning a room for its floor and one for its
 * ceiling. What is above a floor may be furniture and is not told. Places within two
 * cells of a wall or column do not count, nor do those outside of the plan, which
 * coverageOf() tells of. Rooms of both have the same ids. O(columns of the building).
 */
std::vector<PlanWarning> unexplainedSurfaces(const Building& building,
                                             const Floorplan& plan);

} // namespace pcl::sedr
