// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/priors.h>

namespace pcl::sedr {

/** @brief Ends each room at the floors of the rooms above it: where its ceiling is
 * higher, as a roof that is seen through an opening in a slab, it gets a part 1 cm
 * below that floor, of which nothing was seen. So no air is in two rooms. The parts
 * follow what they replace in PlanRoom::details. O(pairs of rooms). */
void endBelowRoomsAbove(Floorplan& plan, const Priors& priors);

} // namespace pcl::sedr
