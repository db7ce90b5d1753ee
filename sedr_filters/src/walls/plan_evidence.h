// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sedr_filters/src/rays/sight_lines.h"

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/point_view.h>

#include <vector>

namespace pcl::sedr {

/** @brief Measures which shares of every wall, column, riser and niche side a scan
 * shows, and stores them in PlanElement::evidence.
 *
 * The surface is divided into cells of 10 cm. A cell is seen if a point of the scan
 * lies within `tolerance` of it. Otherwise it is hidden (by furniture or its shadow) if
 * there are points within a metre in front of it. Below 1 m of height it is also hidden
 * if no floor was seen at its foot. The remaining cells are openings. A surface that
 * was hardly seen counts as hidden.
 *
 * Without scanner positions this is a guess: the shadow of objects more than a metre
 * away counts as an opening. With known positions, a cell that was not seen and that a
 * ray passed through is always an opening.
 *
 * @param points thinned to 5 cm or denser; non-finite points are ignored
 * @param indices the points to use
 * @param tolerance metres, above 0
 * @param threads number of rooms processed in parallel; 0: all processors
 * @param sight rays of the scanners; null: unknown
 *
 * O(n log n + c) for n points and c cells; the result does not depend on the number of
 * threads. */
void measureEvidence(Floorplan& plan,
                     const PointView& points,
                     const std::vector<int>& indices,
                     double tolerance = 0.05,
                     unsigned threads = 0,
                     const SightLines* sight = nullptr);

} // namespace pcl::sedr
