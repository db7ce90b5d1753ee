// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../solver/band_grid.h"

#include <cstddef>
#include <vector>

namespace pcl::sedr {

/** @brief Makes the nodes above zero well composed: where such nodes (or the others)
 * touch only along an edge or at a corner of a cell, one of them changes sign. The
 * faces between nodes of different sign then form a closed manifold surface, and each
 * cell holds at most one piece of it.
 *
 * Nodes with values nearest to zero change first. If that does not converge, nodes
 * above zero change, which terminates. O(blocks) per round.
 * @return the number of nodes that changed */
std::size_t
makeWellComposed(const BandGrid& grid, std::vector<float>& values, unsigned threads);

} // namespace pcl::sedr
