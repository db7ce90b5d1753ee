// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/mesh_distance.h>

#include <string>

namespace pcl::sedr::tools {

/** @brief Draws the histogram of distances as SVG: percentage of points per bin over
 * distance in centimetres, in the colours of distanceColour(). A separate last bar
 * holds greater distances. Empty without a histogram.
 * @param range distance with the last colour, metres */
std::string histogramSvg(const DistanceStatistics& distances, double range);

} // namespace pcl::sedr::tools
