// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sedr_filters/src/grids/cell_mask.h"

#include <Eigen/Core>

#include <vector>

namespace pcl::sedr {

/** @brief A closed polygon along cell edges: corners one cell edge apart, metres. Set
 * cells are on its left: counter-clockwise around a region, clockwise around a hole. */
using Contour = std::vector<Eigen::Vector2d>;

/** @brief Traces all contours of the set cells. Cells that share only a corner are not
 * connected. O(cells). */
std::vector<Contour> traceContours(const CellMask& mask, double cell_size);

/** @brief Returns the signed area of a closed polygon, positive if counter-clockwise.
 */
double signedArea(const std::vector<Eigen::Vector2d>& polygon);

/** @brief Checks whether two edges of a polygon cross or touch that are not adjacent.
 * O(n^2). */
bool crossesItself(const std::vector<Eigen::Vector2d>& polygon);

/** @brief Simplifies a closed polygon such that no removed corner is farther than
 * `tolerance` from it (Douglas and Peucker 1973). */
std::vector<Eigen::Vector2d> simplified(const std::vector<Eigen::Vector2d>& polygon,
                                        double tolerance);

/** @brief Simplifies an open polyline and keeps both its ends. */
std::vector<Eigen::Vector2d> simplifiedLine(const std::vector<Eigen::Vector2d>& line,
                                            double tolerance);

} // namespace pcl::sedr
