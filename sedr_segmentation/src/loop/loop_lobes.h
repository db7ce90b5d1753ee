// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/priors.h>

namespace pcl::sedr {

/** @brief Cuts off where a loop crosses itself: of the two ways from a crossing back to
 * it, the shorter is left out, the smallest such lobe first, until none is left.
 *
 * Where two curves that hardly differ in direction are joined by a short one, their
 * corners may come out in the wrong order; what is between them is such a lobe.
 * @return false, and the loop is as it was, where a lobe is longer than a quarter of
 * the loop, or crossings remain. O(n^2) for n elements and each lobe */
bool cutLobes(PlanLoop& loop, const Priors& priors = {});

/** @brief Drops segments of no length, up to a micrometre, and closes the gaps that
 * they leave: where corners have come to lie in one place, a mesh would have a vertex
 * twice. At least two elements stay. O(n^2) where many are dropped */
void dropPoints(PlanLoop& loop);

} // namespace pcl::sedr
