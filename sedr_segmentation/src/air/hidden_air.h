// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "air_gaps.h"

#include <vector>

namespace pcl::sedr {

/** @brief Gaps for columns in which an end of the air was not seen: furniture hid it,
 * or a beam, or it is below or above a scanner. The missing end is taken from where the
 * air comes from. Which of these columns are air is one labelling, see AirLabelling:
 * where known air and walls are around, so that the ground outside a door is not given
 * a ceiling. O(gaps) and a minimum cut. */
std::vector<AirGap> hiddenAirOf(const AirGaps& air);

} // namespace pcl::sedr
