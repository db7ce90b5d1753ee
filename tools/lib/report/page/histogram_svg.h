// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/mesh_distance.h>

#include <string>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief The histogram of distances as an SVG: share of the points a bin, in percent,
 * over the distance in centimetres, in the colours of distanceColour(); the last bar,
 * apart, is what lies beyond. Empty without a histogram.
 * @param range distance of the last colour, metres */
std::string histogramSvg(const DistanceStatistics& distances, double range);

} // namespace tools
} // namespace sedr
} // namespace pcl
