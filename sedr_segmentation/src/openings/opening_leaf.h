// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "opening_search.h"

namespace pcl::sedr {

/** @brief Sets hinge, swing and state of the doors whose leaf was seen: a sheet as wide
 * and high as the door that stands before either side of the wall and ends at a jamb,
 * or one that shuts it within the wall. Others stay unknown. */
void findLeaves(const Floorplan& plan,
                OpeningSearch& search,
                const OpeningParameters& parameters);

} // namespace pcl::sedr
