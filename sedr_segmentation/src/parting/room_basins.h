// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../air/air_gaps.h"
#include "parting_parameters.h"

#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief Parts air at its constrictions: basins of the distance from what ends the
 * air, lintels counted as ends. Two basins that meet in a neck about as wide as the
 * narrower of them are one. What no basin holds, below lintels, goes to the nearest.
 * O(gaps log gaps).
 * @param dip of each gap, see dipOfCeiling()
 * @return a label for each gap, PartedAir::no_room for what none reaches */
std::vector<std::int32_t> roomBasins(const AirGaps& air,
                                     const std::vector<float>& dip,
                                     const PartingParameters& parameters);

} // namespace pcl::sedr
