// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "air_gaps.h"

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

} // namespace pcl::sedr
