// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <utility>
#include <vector>

namespace pcl::sedr {

/** @brief Cuts two loops at their intersections. Returns the parts of the first inside
 * the second, and of the second inside the first; none if they do not overlap. O(n m).
 */
std::pair<std::vector<PlanElement>, std::vector<PlanElement>>
partsInside(const PlanLoop& first, const PlanLoop& second);

/** @brief Offsets a counter-clockwise loop outwards by `by` metres, inwards if
 * negative. Arcs stay arcs; short segments close gaps between neighbours. */
PlanLoop widened(const PlanLoop& loop, double by);

/** @brief Returns the interior of `loop` minus that of `cutter`, both
 * counter-clockwise. Outer loops come first, counter-clockwise and largest first, then
 * clockwise loops of holes. Elements taken from `cutter` have no inliers. Empty if
 * nothing is left. `loop` may also hold the elements of clockwise loops of holes.
 * O(n m). */
std::vector<PlanLoop> difference(const PlanLoop& loop, const PlanLoop& cutter);

/** @brief Returns the common interior of `loop` and `other`, both counter-clockwise,
 * largest first. Either may also hold the elements of clockwise loops of holes; those
 * of the result come last. Elements taken from `other` have no inliers. Empty if they
 * do not overlap. O(n m). */
std::vector<PlanLoop> intersection(const PlanLoop& loop, const PlanLoop& other);

} // namespace pcl::sedr
