// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plane_fit.h"

#include <vector>

namespace pcl {
namespace sedr {

/** @brief Of some slabs the one that most of the points agree with, the first of
 * equals; `start` where none does better. A point agrees by 1 with a slab that it is
 * on, down to 0 at the tolerance, so that a thin layer wins over a thick one. O(slabs
 * times points); the same for any number of threads, 0: as many as there are
 * processors. */
PlanSlab mostAgreed(const std::vector<PlanSlab>& slabs,
                    const PlanSlab& start,
                    const Positions& points,
                    double tolerance,
                    unsigned threads);

} // namespace sedr
} // namespace pcl
