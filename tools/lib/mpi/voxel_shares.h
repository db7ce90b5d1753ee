// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sedr_filters/src/voxels/voxel_frame.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief The codes of a voxel. */
using VoxelKey = std::array<std::int32_t, 3>;

/** @brief Every so many of the keys of a sorted list: enough of it to deal it out. */
std::vector<VoxelKey> keysOf(const std::vector<VoxelSum>& voxels);

/** @brief Where to part the voxels of several ranks so that each of `ranks` gets about
 * as many, those of one key in one place.
 * @param keys of keysOf() of all ranks, in any order
 * @return the least key of each rank but the first, ascending */
std::vector<VoxelKey> bordersOf(std::vector<VoxelKey> keys, std::size_t ranks);

/** @brief Where each rank's voxels begin in a sorted list, and where the last one's
 * end. */
std::vector<std::size_t> sharesOf(const std::vector<VoxelSum>& voxels,
                                  const std::vector<VoxelKey>& borders);

} // namespace tools
} // namespace sedr
} // namespace pcl
