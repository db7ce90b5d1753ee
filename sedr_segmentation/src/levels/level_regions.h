// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "level_candidates.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief The marked cells of a level less those of walls, which go on above or below
 * it. O(n).
 * @param marked 1 for the cells of the level */
std::vector<std::uint8_t> withoutWalls(const LevelColumns& columns,
                                       const std::vector<std::uint8_t>& marked,
                                       const PlanSlab& slab,
                                       double tolerance);

/** @brief The eight-connected regions of marked cells that are large enough, largest
 * first. O(n log n).
 * @param minimum_cells least size of a region
 * @return the positions of each region's cells, increasing */
std::vector<std::vector<std::size_t>> regionsOf(const CellSet& cells,
                                                const std::vector<std::uint8_t>& marked,
                                                std::size_t minimum_cells);

/** @brief The regions of a level's cells that are large enough, see regionsOf(); walls
 * part them. O(n log n).
 * @param marked 1 for the cells of the level */
std::vector<std::vector<std::size_t>>
levelRegions(const LevelColumns& columns,
             const std::vector<std::uint8_t>& marked,
             const PlanSlab& slab,
             double tolerance,
             std::size_t minimum_cells);

} // namespace sedr
} // namespace pcl
