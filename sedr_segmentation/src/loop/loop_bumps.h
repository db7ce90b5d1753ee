// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

namespace pcl::sedr {

/** @brief Leads a loop straight on where it leaves a straight wall and comes back to
 * it, or to one parallel to it within 5 degrees, and is nowhere
 * `narrowest` metres away from where it left, along the wall or off it: at a cable, a
 * curtain, a corner of two scans that do not agree. Where there are two or more such
 * short sides between a wall and another one, the walls meet in their corner. A
 * pilaster or a groove with sides square to the wall or along it, within 10 degrees,
 * stays, however narrow. Where
 * parallel walls are apart, a step is left, at the end of the bump that is squarer.
 * @return how many bumps were dropped. O(n) for n elements, and for each bump */
int dropBumps(PlanLoop& loop, double narrowest);

} // namespace pcl::sedr
