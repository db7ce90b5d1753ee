// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "opening_search.h"

namespace pcl::sedr {

/** @brief Names the kind of each opening by log-odds of what was measured of it. Below
 * a probability of one half it is unknown, as is a door or passage too low to walk.
 * Only doors have leaves; one that shuts a door within its wall is closed. */
void
nameOpenings(const Floorplan& plan, OpeningSearch& search, const OpeningSizes& sizes);

} // namespace pcl::sedr
