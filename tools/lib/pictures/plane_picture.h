// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "picture.h"

#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_segmentation/horizontal_plane_detection.h>

#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief What HorizontalPlaneDetection decided: at which heights how much is seen, and
 * the planes in plan, ceilings, floors and others each in their colour.
 * @param points the cloud that the planes' indices are of
 * @param cell_size of the maps, metres */
Picture drawPlanes(const std::vector<pcl::HorizontalPlane>& planes,
                   const HeightHistogram& histogram,
                   const PointView& points,
                   double cell_size);

} // namespace tools
} // namespace sedr
} // namespace pcl
