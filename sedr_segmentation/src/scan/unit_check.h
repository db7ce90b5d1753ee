// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/point_view.h>

#include <cstddef>
#include <string>

namespace pcl {
namespace sedr {

/** @brief Whether a scan looks as if its unit were the inch: a sentence, else empty.
 * Then it is 60 to 200 high, as one storey or two are in inches, and more than 30 for
 * each storey that was found, as no tower is. The outermost hundredths of the points do
 * not count. Above 200 the check of the scan tells the unit. O(points).
 * @param storeys that were found; 0 where nothing was */
std::string inchProblem(const PointView& points, std::size_t storeys);

} // namespace sedr
} // namespace pcl
