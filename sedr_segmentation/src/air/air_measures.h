// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "air_gaps.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief The height of the ceiling of each gap, metres, raised where it dips for less
 * than `reach` cells from a side: below ribs and beams (grey closing along the air).
 * O(gaps reach). */
std::vector<float> closedCeiling(const AirGaps& air, int reach);

/** @brief How far the ceiling of each gap dips below what it is on both sides within
 * `reach` cells (grey closing along the air), metres: lintels and beams. Holes in the
 * ceiling narrower than that, and the spaces between ribs, are closed first (grey
 * opening). O(gaps reach). */
std::vector<float> dipOfCeiling(const AirGaps& air, int reach);

/** @brief For each gap that is `inside` (none told: all), how far it is along the air
 * from the nearest place where the air ends or is not inside, in cells (chamfer
 * distance: 8 % off at most); 0 for the others. O(gaps). */
std::vector<float> distanceToRim(const AirGaps& air,
                                 const std::vector<std::uint8_t>& inside = {});

/** @brief The same, to the rim or to where the ceiling dips by `lintel` metres.
 * @param dip of each gap, see dipOfCeiling() */
std::vector<float>
distanceToLintel(const AirGaps& air, const std::vector<float>& dip, double lintel);

/** @brief Whether a wall stands in a column or beside it at the heights of a gap: much
 * of the upper two thirds is occupied; furniture may hide the rest. */
bool isWallAt(const AirGaps& air, std::uint32_t column, const AirGap& gap);

/** @brief Whether a wall stands within three columns of a gap in plan_directions[d]. */
bool isWallBeside(const AirGaps& air, std::size_t g, int d);

} // namespace pcl::sedr
