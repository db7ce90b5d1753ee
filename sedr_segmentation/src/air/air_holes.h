// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "air_gaps.h"

#include <vector>

namespace pcl::sedr {

/** @brief Gaps for columns in which the floor or the ceiling of the air beside was seen
 * and the other was not: furniture hid it, or a beam. The missing end is taken from
 * where the air comes from. Regions of such columns are taken whole, and only where
 * they are enclosed: by known air along a part of their rim, by walls along most of the
 * rest. So the ground outside a door is not given a ceiling. O(gaps). */
std::vector<AirGap> enclosedHolesOf(const AirGaps& air);

} // namespace pcl::sedr
