// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "opening_search.h"

namespace pcl::sedr {

/** @brief Sets hinge, swing and state of the openings beside which a leaf stands open:
 * a sheet as wide and high as the opening, or two of half its width, that begins at a
 * jamb and ends. Those are turned so that the leaf is to the left of their direction.
 * Others stay unknown.
 * @param indices of the points to use; null: all */
void findLeaves(const Floorplan& plan,
                const PointView& points,
                const pcl::Indices* indices,
                const OpeningSizes& sizes,
                unsigned threads,
                std::vector<FoundOpening>& found);

} // namespace pcl::sedr
