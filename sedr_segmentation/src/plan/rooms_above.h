// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/priors.h>

namespace pcl::sedr {

/** @brief Ends each room at the floors of the rooms above it: where its ceiling is
 * higher, as a roof that is seen beside a gallery, it gets a part 1 cm below that
 * floor, the lowest one if there are several, of which nothing was seen. Shafts of the
 * room above (its columns) stay the lower room's, and no ceiling is raised. The parts
 * follow what they replace in PlanRoom::details; a detail of which only strips are left
 * goes. The heights of a relief are lowered. Left as they are: rooms that share heights
 * (shareHeights()), other curved ceilings that are partly lower, and strips narrower
 * than Priors::min_wall. O(rooms squared), and for rooms that overlap in plan O(n m) of
 * the elements of their ceilings and floors. */
void endBelowRoomsAbove(Floorplan& plan, const Priors& priors);

} // namespace pcl::sedr
