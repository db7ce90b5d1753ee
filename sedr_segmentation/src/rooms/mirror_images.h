// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_segmentation/building.h>

#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief Which parts of the air are what a floor mirrors of the room above it: below
 * most of their columns, as high as the air above, and no slab between. O(columns log
 * columns).
 * @param surface thickest that one surface may be, metres
 * @return 1 for each such part */
std::vector<std::uint8_t> mirrorImages(const std::vector<BuildingRoom>& parts,
                                       double surface);

} // namespace pcl::sedr
