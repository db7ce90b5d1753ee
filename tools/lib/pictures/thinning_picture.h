// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "picture.h"

#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/row_source.h>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief What ParallelVoxelGrid did: how many points lie in each cell of the plan
 * before and after.
 * @param leaf edge of a voxel and of a cell, metres */
Picture drawThinning(const PointView& before, const PointView& after, double leaf);

/** @brief The same of a scan that comes in pieces. */
Picture drawThinning(const RowSource& before, const PointView& after, double leaf);

} // namespace tools
} // namespace sedr
} // namespace pcl
