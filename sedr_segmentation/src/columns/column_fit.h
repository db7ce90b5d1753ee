// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../loop/loop_fit.h"
#include <pcl/sedr_filters/floorplan.h>

#include <vector>

namespace pcl {
namespace sedr {

/** @brief The outline of a column.
 *
 * A circle, a rectangle along the given directions, a rectangle that is turned and any
 * loop of segments and arcs compete: what leaves fewer points unexplained wins, the
 * simpler where that is equal. A side of a rectangle that nobody saw is where those
 * beside it end.
 *
 * @param hole the contour of the column's hole in the room, clockwise; up to a cell
 * wider than the column
 * @param evidence points of walls and columns, in plan
 * @param directions unit directions of the room's walls
 * @param[out] places the samples of the contour, if wanted
 * @return a clockwise loop; empty for a contour of fewer than four corners. O(n) for n
 * points of the column. */
PlanLoop fitColumn(const Contour& hole,
                   const PlanPoints& evidence,
                   const std::vector<Eigen::Vector2d>& directions,
                   const LoopParameters& parameters,
                   std::vector<ContourSample>* places = nullptr);

} // namespace sedr
} // namespace pcl
