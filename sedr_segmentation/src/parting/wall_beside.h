// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../air/air_gaps.h"

#include <cstddef>
#include <cstdint>

namespace pcl::sedr {

/** @brief Whether a wall stands in a column or beside it at the heights of a gap: much
 * of the upper two thirds is occupied; furniture may hide the rest. */
bool isWallAt(const AirGaps& air, std::uint32_t column, const AirGap& gap);

/** @brief Whether a wall stands within three columns of a gap in plan_directions[d]. */
bool isWallBeside(const AirGaps& air, std::size_t g, int d);

} // namespace pcl::sedr
