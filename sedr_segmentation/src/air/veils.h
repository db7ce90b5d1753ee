// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "air_gaps.h"

#include <vector>

namespace pcl::sedr {

/** @brief The gaps of a scan, those joined that only a veil parts: points between two
 * surfaces at different distances, which a scanner reports where its beam meets the
 * edge of the nearer one, as above the leaf of a door or a partition. A veil has less
 * than 60 % of the points that the surface behind it has: what is seen through it
 * cannot be behind a surface. One of the two gaps is lower than the headroom, and is
 * not the inside of a slab between storeys; beside a veil the air goes on through its
 * height, which it does not beside the head of a door. O(gaps).
 * @param fine columns half as wide as those of the gaps, with all that was seen
 * @return all gaps, in their order */
std::vector<AirGap> withoutVeils(const AirGaps& air, const VoxelColumns& fine);

} // namespace pcl::sedr
