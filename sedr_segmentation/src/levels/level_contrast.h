// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "level_candidates.h"

#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief Returns whether the points around some cells are denser at a slab than above
 * and below it. Within half a tolerance there must be more than twice as many as one to
 * two tolerances above, and below. Clutter has no such maximum.
 *
 * Isolated points always stand out in their own cells, as the cells were chosen for
 * them. For a level of such points, only the cells around its own are counted: points
 * of a surface have neighbours at their height, outliers at any height. O(n).
 * @param marked 1 for the cells of the slab */
bool standsOut(const LevelColumns& columns,
               const std::vector<std::uint8_t>& marked,
               const PlanSlab& slab,
               double tolerance);

} // namespace pcl::sedr
