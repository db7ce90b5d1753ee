// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "picture.h"

#include <pcl/sedr_filters/grid_region_outlier_removal.h>

#include <vector>

namespace pcl::sedr::tools {

/** @brief Draws the result of GridRegionOutlierRemoval (paper, Figure 3b to d): the
 * binary map, the regions with their sizes, and which of them are kept.
 * @param maps one per run: per ceiling height */
Picture drawRegions(const std::vector<RegionMap>& maps);

} // namespace pcl::sedr::tools
