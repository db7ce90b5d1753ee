// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "opening_search.h"

namespace pcl::sedr {

/** @brief Keeps those that are openings by log-odds of what was measured of them, each
 * once, and names their kinds. Below a probability of one half a kind is unknown, as is
 * that of a door or passage too low to walk. Only doors have leaves; one that shuts a
 * door within its wall is closed. */
void
nameOpenings(const Floorplan& plan, OpeningSearch& search, const OpeningSizes& sizes);

} // namespace pcl::sedr
