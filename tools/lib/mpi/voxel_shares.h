// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sedr_filters/src/voxels/voxel_frame.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::sedr::tools {

/** @brief The codes of a voxel. */
using VoxelKey = std::array<std::int32_t, 3>;

/** @brief Returns a regular sample of the keys of a sorted list, for distributing
 * it. */
std::vector<VoxelKey> keysOf(const std::vector<VoxelSum>& voxels);

/** @brief Computes borders that give each of `ranks` about the same number of voxels,
 * with equal keys on one rank.
 * @param keys from keysOf() of all ranks, in any order
 * @return the lowest key of each rank but the first, ascending */
std::vector<VoxelKey> bordersOf(std::vector<VoxelKey> keys, std::size_t ranks);

/** @brief Returns where each rank's voxels begin in a sorted list, and the end of the
 * last. */
std::vector<std::size_t> sharesOf(const std::vector<VoxelSum>& voxels,
                                  const std::vector<VoxelKey>& borders);

} // namespace pcl::sedr::tools
