// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

namespace pcl::sedr {

/** @brief Clips the ceiling and floor details of a room to its boundary where they
 * exceed it by more than a millimetre. A detail may be split into several or removed.
 * O(n m) for n elements of the boundary and m of the details. */
void trimDetails(PlanRoom& room);

} // namespace pcl::sedr
