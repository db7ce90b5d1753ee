// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../air/air_gaps.h"
#include "parting_parameters.h"

#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief Lines from jamb to jamb in doorways without a lintel: straight, no longer
 * than the widest door, from wall to wall, and within a wall's thickness the air is
 * wider on both sides. So a doorway to a corridor is found however narrow the corridor
 * is.
 * @param distance of each gap from the rim of what may be crossed, in columns, see
 *        distanceToRim(); 0 elsewhere
 * @return 1 for the gaps on such lines. O(gaps) times a door's width. */
std::vector<std::uint8_t> jambLines(const AirGaps& air,
                                    const std::vector<float>& distance,
                                    const PartingParameters& parameters);

} // namespace pcl::sedr
