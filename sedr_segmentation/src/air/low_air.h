// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "air_gaps.h"

#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief Which gaps are air. Those with headroom are. Lower ones hang together as
 * patches, of one floor and one ceiling: such a patch is the air above a table, below a
 * sloping roof or a beam, or the void within a slab. It is air if at least
 * AirParameters::min_air of its rim is air whose ceiling goes on above it: the void
 * within a slab meets that of a room only where the ceiling was not seen.
 * @return 1 for each gap that is air, else 0. O(gaps). */
std::vector<std::uint8_t> airOf(const AirGaps& gaps);

} // namespace pcl::sedr
