// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../solver/band_grid.h"

#include <cstddef>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Makes the nodes above zero well composed: wherever such nodes (or the others)
 * would touch along an edge or at a corner of a cell alone, the sign of one of them
 * changes. Then the faces between nodes of different sign make up a closed manifold
 * surface, and each cell holds one piece of it at most.
 *
 * Those nodes go first whose values are nearest to zero; if that does not settle it,
 * nodes above zero go, which comes to an end. O(blocks) a round.
 * @return the number of nodes that changed */
std::size_t
makeWellComposed(const BandGrid& grid, std::vector<float>& values, unsigned threads);

} // namespace sedr
} // namespace pcl
