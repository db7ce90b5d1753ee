// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../loop/loop_fit.h"
#include <pcl/sedr_filters/floorplan.h>

#include <vector>

namespace pcl::sedr {

/** @brief Fits the outline of a column.
 *
 * The candidates are a circle, a rectangle along the given directions, a rotated
 * rectangle, and a free loop of segments and arcs. The shape that leaves the fewest
 * points unexplained wins, the simpler one on a tie. An unseen side of a rectangle lies
 * where the adjacent sides end.
 *
 * @param hole the contour of the column's hole in the room, clockwise; up to a cell
 * wider than the column
 * @param evidence points of walls and columns, in plan
 * @param directions unit directions of the room's walls
 * @param[out] places the samples of the contour; optional
 * @return a clockwise loop; empty for a contour of fewer than four corners. O(n) for n
 * points of the column. */
PlanLoop fitColumn(const Contour& hole,
                   const PlanPoints& evidence,
                   const std::vector<Eigen::Vector2d>& directions,
                   const LoopParameters& parameters,
                   std::vector<ContourSample>* places = nullptr);

} // namespace pcl::sedr
