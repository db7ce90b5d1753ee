// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

namespace pcl::sedr {

/** @brief Makes one element of neighbours that follow one line or circle the same
 * way, with the inliers of that curve. O(n squared) at most. */
void joinNeighbours(PlanLoop& loop);

} // namespace pcl::sedr
