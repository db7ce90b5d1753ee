// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "level_candidates.h"

#include <cstdint>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Whether the points about some cells are denser at a slab than beside it:
 * within half a tolerance there are more than twice as many as between one and two
 * tolerances above, and below. Clutter is as dense everywhere, and has an end.
 *
 * Single points, each in a cell of its own, stand out there whatever they are, for the
 * cells were chosen for them. So where a level is made of such, what lies around its
 * cells counts, not what is in them: points of a surface have others at their height
 * around them, strays at any. O(n).
 * @param marked 1 for the cells of the slab */
bool standsOut(const LevelColumns& columns,
               const std::vector<std::uint8_t>& marked,
               const PlanSlab& slab,
               double tolerance);

} // namespace sedr
} // namespace pcl
