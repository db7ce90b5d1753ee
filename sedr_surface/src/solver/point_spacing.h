// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/impl/room_samples.h>

#include <vector>

namespace pcl::sedr {

/** @brief Estimates the distance between neighbouring points of a surface, metres: the
 * side of the square per point, median by area, from at most 4000 points. Zero for
 * fewer than 10 points. O(n log n). */
double measureSpacing(const std::vector<OrientedPoint>& points);

} // namespace pcl::sedr
