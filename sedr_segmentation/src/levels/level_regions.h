// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "level_candidates.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief Returns the marked cells of a level without those of walls, which continue
 * above or below it. O(n).
 * @param marked 1 for the cells of the level */
std::vector<std::uint8_t> withoutWalls(const LevelColumns& columns,
                                       const std::vector<std::uint8_t>& marked,
                                       const PlanSlab& slab,
                                       double tolerance);

/** @brief Returns the eight-connected regions of marked cells of the minimum size,
 * largest first. O(n log n).
 * @param minimum_cells minimum size of a region
 * @return the positions of each region's cells, increasing */
std::vector<std::vector<std::size_t>> regionsOf(const CellSet& cells,
                                                const std::vector<std::uint8_t>& marked,
                                                std::size_t minimum_cells);

/** @brief Returns the regions of a level's cells of the minimum size, separated by
 * walls, see regionsOf(). O(n log n).
 * @param marked 1 for the cells of the level */
std::vector<std::vector<std::size_t>>
levelRegions(const LevelColumns& columns,
             const std::vector<std::uint8_t>& marked,
             const PlanSlab& slab,
             double tolerance,
             std::size_t minimum_cells);

} // namespace pcl::sedr
