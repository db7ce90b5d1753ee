// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "picture.h"

#include <pcl/sedr_filters/point_view.h>

namespace pcl::sedr::tools {

/** @brief Draws the result of ParallelVoxelGrid: the number of points per cell of the
 * plan before and after.
 * @param leaf edge of a voxel and of a cell, metres */
Picture drawThinning(const PointView& before, const PointView& after, double leaf);

/** @brief As above, for a scan that is read in pieces. */
Picture drawThinning(const RowSource& before, const PointView& after, double leaf);

} // namespace pcl::sedr::tools
