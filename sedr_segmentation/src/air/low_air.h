// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "air_gaps.h"

#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief Which gaps are air. Those with headroom are. Lower ones are the air above a
 * table, below a sloping roof or a beam, or the void within a slab: one labelling, see
 * AirLabelling, tells which go on from tall air below the same ceiling. The void within
 * a slab meets that of a room only where the ceiling was not seen.
 * @return 1 for each gap that is air, else 0. O(gaps) and a minimum cut. */
std::vector<std::uint8_t> airOf(const AirGaps& gaps);

} // namespace pcl::sedr
