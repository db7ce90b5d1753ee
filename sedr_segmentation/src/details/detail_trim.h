// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

namespace pcl {
namespace sedr {

/** @brief Cuts off what of the details of a room, of its ceiling and of its floor, is
 * outside of its boundary by more than a millimetre. A detail of which several parts
 * are left becomes as many, and one of which none is left goes. O(n m) for n elements
 * of the boundary and m of the details. */
void trimDetails(PlanRoom& room);

} // namespace sedr
} // namespace pcl
