// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief Mean height of a room in metres, over samples of its floor every 10 cm; 0 if
 * none lies in it. */
double meanHeight(const PlanRoom& room);

/** @brief What a room of this mean height encloses, its niches too, cubic metres. */
double volumeOf(const PlanRoom& room, double mean_height);

} // namespace tools
} // namespace sedr
} // namespace pcl
