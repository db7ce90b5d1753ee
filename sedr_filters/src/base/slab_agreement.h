// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plane_fit.h"

#include <vector>

namespace pcl::sedr {

/** @brief Returns the slab with the highest agreement, the first of equals; `start` if
 * none is better. A point scores 1 on the slab, falling to 0 at the tolerance, so a
 * thin layer wins over a thick one. O(slabs times points). The result does not depend
 * on `threads`; 0 for all processors. */
PlanSlab mostAgreed(const std::vector<PlanSlab>& slabs,
                    const PlanSlab& start,
                    const Positions& points,
                    double tolerance,
                    unsigned threads);

} // namespace pcl::sedr
