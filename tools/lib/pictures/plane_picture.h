// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "picture.h"

#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_segmentation/horizontal_plane_detection.h>

#include <vector>

namespace pcl::sedr::tools {

/** @brief Draws the result of HorizontalPlaneDetection: a histogram of heights, and the
 * planes in plan, coloured as ceilings, floors and others.
 * @param points the cloud of the planes' indices
 * @param cell_size of the maps, metres */
Picture drawPlanes(const std::vector<pcl::HorizontalPlane>& planes,
                   const HeightHistogram& histogram,
                   const PointView& points,
                   double cell_size);

} // namespace pcl::sedr::tools
