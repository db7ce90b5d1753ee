// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "voxel_table.h"

#include <vector>

namespace pcl {
namespace sedr {

/** @brief The voxels of all VoxelTable::table_count `tables`, sorted by z, then y, then
 * x; the tables are released. O(n log n). */
std::vector<VoxelSum> takeSorted(VoxelTable* tables, unsigned threads);

} // namespace sedr
} // namespace pcl
