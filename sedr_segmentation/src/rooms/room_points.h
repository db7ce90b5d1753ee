// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../air/voxel_columns.h"

#include <pcl/sedr_segmentation/building.h>

#include <vector>

namespace pcl::sedr {

/** @brief Labels the points of ceilings and floors with their rooms: those near where
 * the air of their column, or of one beside it, ends. Points of walls, which go on
 * below a ceiling, are left out. O(n).
 * @param fine small columns, by which walls are told
 * @param coarse columns of the size of those of the rooms */
void labelSheets(const PointView& points,
                 const std::vector<int>& indices,
                 const VoxelColumns& fine,
                 const VoxelColumns& coarse,
                 unsigned threads,
                 Building& building);

} // namespace pcl::sedr
