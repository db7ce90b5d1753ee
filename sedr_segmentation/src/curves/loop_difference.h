// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <utility>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief The parts of two loops between where they meet: `first` those of the first
 * loop that lie inside of the second, `second` those of the second inside of the first.
 * Loops that do not overlap have none. O(n m). */
std::pair<std::vector<PlanElement>, std::vector<PlanElement>>
partsInside(const PlanLoop& first, const PlanLoop& second);

/** @brief A counter-clockwise loop `by` metres farther out all around, farther in where
 * that is negative. Arcs stay arcs; where neighbours part, a short segment joins them.
 */
PlanLoop widened(const PlanLoop& loop, double by);

/** @brief What is left of the inside of `loop` without that of `cutter`, both
 * counter-clockwise: outer loops counter-clockwise, largest first, then clockwise ones
 * for holes. Segments and arcs of `cutter` that bound it come without inliers. Empty
 * where nothing is left. O(n m). */
std::vector<PlanLoop> difference(const PlanLoop& loop, const PlanLoop& cutter);

/** @brief What of the inside of `loop` is inside of `other` as well, both
 * counter-clockwise, largest first. Segments and arcs of `other` that bound it come
 * without inliers. Empty where they do not overlap. O(n m). */
std::vector<PlanLoop> intersection(const PlanLoop& loop, const PlanLoop& other);

} // namespace sedr
} // namespace pcl
