// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "picture.h"

#include "sedr_segmentation/src/openings/opening_search.h"

namespace pcl::sedr::tools {

/** @brief Draws the maps of the sides of walls on which OpeningDetection found
 * openings, the longest first: what was seen of each cell, and the openings. */
Picture drawOpenings(const Floorplan& plan, const OpeningSearch& search);

} // namespace pcl::sedr::tools
