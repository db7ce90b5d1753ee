// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/sight_lines.h>

#include <cstddef>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Looks what a scan shows of every wall, column, riser and side of a niche, and
 * notes it in PlanElement::evidence.
 *
 * The surface is cut into cells of 10 cm. One with a point of the scan within
 * `tolerance` of it is seen. Of the others, one that has points in the metre before it,
 * below 1 m of height also one without floor at its foot, is hidden: by furniture, or
 * in its shadow. What is left is an opening. Of a surface of which next to nothing was
 * seen all is hidden. Without the places of the scanner this is a guess: the shadow of
 * what stands more than a metre away counts as an opening. Where they are known, a cell
 * that was not seen and that a ray went through is an opening in any case.
 *
 * @param points thinned to a point in 5 cm or denser; not finite ones are left out
 * @param indices those of them that count
 * @param tolerance metres, above 0
 * @param threads rooms looked at at a time; 0: as many as there are processors
 * @param sight rays of the scanners; null: not known
 *
 * O(n log n + c) for n points and c cells; the same for any number of threads. */
void measureEvidence(Floorplan& plan,
                     const PointView& points,
                     const std::vector<int>& indices,
                     double tolerance = 0.05,
                     unsigned threads = 0,
                     const SightLines* sight = nullptr);

} // namespace sedr
} // namespace pcl
