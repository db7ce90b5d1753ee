// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/point_view.h>

#include <cstddef>
#include <string>

namespace pcl::sedr {

/** @brief Returns a sentence if the unit of a scan seems to be the inch, else an empty
 * one. The scan must be 60 to 200 high, like one or two storeys in inches, and more
 * than 30 per storey found, unlike any tower. The outermost tenth of the points at each
 * end is ignored. Above 200, the check of the scan detects the unit. O(points).
 * @param storeys number of storeys found */
std::string inchProblem(const PointView& points, std::size_t storeys);

} // namespace pcl::sedr
