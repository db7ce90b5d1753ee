// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "picture.h"

#include "sedr_segmentation/src/details/slice_detail.h"
#include <pcl/sedr_filters/point_view.h>
#include <pcl/types.h>

#include <cstdint>
#include <vector>

namespace pcl::sedr::tools {

/** @brief The grid-slices analysis of one room. */
struct RoomSlices {
  std::uint32_t room = 0; ///< 0: the only one
  SliceDetails analysis;
  pcl::Indices points;  ///< points analysed
  pcl::Indices ceiling; ///< main ceiling of these
};

/** @brief Draws the result of GridSliceDetail (paper, Figure 4): a map per trial with
 * the cells of ceiling and slices and the zero-valued regions, a map of the details,
 * and a vertical section with the heights of the slices.
 * @param points the cloud of the indices
 * @param cell_size of the analysis, metres */
Picture drawSlices(const std::vector<RoomSlices>& rooms,
                   const PointView& points,
                   double cell_size);

} // namespace pcl::sedr::tools
