// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../air/air_gaps.h"

#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief For each gap that is `inside` (none told: all), how far it is along the air
 * from the nearest place where the air ends or is not inside, in cells (chamfer
 * distance: 8 % off at most); 0 for the others. O(gaps). */
std::vector<float> distanceToRim(const AirGaps& air,
                                 const std::vector<std::uint8_t>& inside = {});

/** @brief The same, to the rim or to where the ceiling dips by `lintel` metres.
 * @param dip of each gap, see dipOfCeiling() */
std::vector<float>
distanceToLintel(const AirGaps& air, const std::vector<float>& dip, double lintel);

} // namespace pcl::sedr
