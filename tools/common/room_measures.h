// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief Mean height of a room in metres, over samples of its floor every 10 cm; 0 if
 * none lies in it. */
double meanHeight(const PlanRoom& room);

} // namespace tools
} // namespace sedr
} // namespace pcl
