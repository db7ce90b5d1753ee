// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/plan_warning.h>

#include <vector>

namespace pcl::sedr {

/** @brief Returns what of a plan is unlikely in a flat or office, and worth a look:
 * rooms without a door, below 2 m2, narrower than 0.8 m, lower than 2 or higher than 6
 * m, or with more than 8 walls of less than 1.25 m on average; doors below 0.7 m; arcs
 * that are as flat as their noise; walls in line with the edge of a soffit that goes on
 * where they end; lower parts of a ceiling at a wall of which 0.25 m2 or more were not
 * seen; raised floors that stand free or in a corner; storeys below 5 m2. All have a
 * place. O(elements). */
std::vector<PlanWarning> unlikelyPlaces(const Floorplan& plan);

} // namespace pcl::sedr
