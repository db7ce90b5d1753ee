// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../air/air_gaps.h"

#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief Which gaps stand on a floor: on what one walks about on without climbing, a
 * strip as wide as a wall is thick or a square of twice that, and no top of furniture.
 * Such a top is higher by more than AirParameters::highest_step than a larger floor
 * beside it, and not over air of the same storey in which one can stand, as a gallery
 * is. O(gaps).
 * @param thickest_wall metres
 * @return 1 for gaps with headroom on a floor, else 0 */
std::vector<std::uint8_t> standOnFloor(const AirGaps& air, double thickest_wall);

} // namespace pcl::sedr
