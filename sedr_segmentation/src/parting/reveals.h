// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../air/air_gaps.h"

#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief Which gaps lie within the thickness of a wall, below the lintel of a door or
 * the head of a window: parts of a room with a lower ceiling, walls at both sides, from
 * which the room goes on beside these walls. O(gaps).
 * @param dip of each gap, see dipOfCeiling()
 * @param lintel least dip, metres
 * @param room of each gap, -1 for none */
std::vector<std::uint8_t> revealsOf(const AirGaps& air,
                                    const std::vector<float>& dip,
                                    double lintel,
                                    const std::vector<std::int32_t>& room);

} // namespace pcl::sedr
