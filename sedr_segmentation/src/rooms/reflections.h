// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/cell_grid.h>
#include <pcl/sedr_filters/point_view.h>
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

/** @brief Which parts of the air were seen only through panes of glass or in mirrors:
 * those whose points in their columns are nine tenths of that kind. O(n log n) for n
 * points and columns.
 * @param grid of the columns
 * @param behind 1 for each point that was seen only through panes; empty: not known
 * @return 1 for each such part */
std::vector<std::uint8_t> viewsThroughPanes(const std::vector<BuildingRoom>& parts,
                                            const CellGrid& grid,
                                            const PointView& points,
                                            const std::vector<std::uint8_t>& behind);

} // namespace pcl::sedr
