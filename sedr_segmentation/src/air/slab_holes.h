// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "air_gaps.h"

#include <vector>

namespace pcl::sedr {

/** @brief The gaps of a scan with those parted that reach through a hole in what was
 * seen of a slab: two rooms above each other are known on both sides of it, and neither
 * the ceiling of the lower nor the floor of the upper was seen in it. The ends are
 * those of the slab beside it, and not seen. A hole larger than
 * AirParameters::largest_hole is a void or a stairwell and stays open. O(gaps) for each
 * storey.
 * @return all gaps, not sorted */
std::vector<AirGap> withSlabsClosed(const AirGaps& air);

} // namespace pcl::sedr
