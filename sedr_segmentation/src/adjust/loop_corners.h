// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan_ties.h"
#include "plan_unknowns.h"

#include <cstddef>
#include <vector>

namespace pcl::sedr {

/** @brief Rebuilds the loops of a plan on moved unknowns: corners are intersections of
 * neighbouring curves, or the points where tied curves touch.
 * @param are_kept unknowns that were not moved; loops of these alone do not change
 * @param farthest maximum move of a corner between square walls, metres
 * @return the unknowns at whose elements loops would break, i.e. cross themselves,
 * reverse an element or lose a corner. The plan is changed only if there are none. */
std::vector<std::size_t> rebuildLoops(const PlanUnknowns& plan,
                                      const std::vector<PlanTie>& ties,
                                      const std::vector<bool>& are_kept,
                                      double farthest);

} // namespace pcl::sedr
