// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "level_candidates.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief The eight-connected regions of a level's cells that are large enough, largest
 * first. What goes on above or below the level is a wall: it parts them. O(n log n).
 * @param marked        1 for the cells of the level
 * @param minimum_cells least size of a region
 * @return the positions of each region's cells, increasing */
std::vector<std::vector<std::size_t>>
levelRegions(const LevelColumns& columns,
             const std::vector<std::uint8_t>& marked,
             const PlanSlab& slab,
             double tolerance,
             std::size_t minimum_cells);

} // namespace sedr
} // namespace pcl
