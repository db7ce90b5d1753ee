// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sedr_filters/src/grids/cell_mask.h"

#include <Eigen/Core>

#include <vector>

namespace pcl {
namespace sedr {

/** @brief A closed way along cell edges: the corners in order, one cell edge apart,
 * metres. The set cells are on the left: counter-clockwise around a region, clockwise
 * around a hole. */
using Contour = std::vector<Eigen::Vector2d>;

/** @brief All contours of the set cells; cells that touch by a corner only are apart.
 * O(cells). */
std::vector<Contour> traceContours(const CellMask& mask, double cell_size);

/** @brief Twice-integrated area of a closed polygon, positive counter-clockwise. */
double signedArea(const std::vector<Eigen::Vector2d>& polygon);

/** @brief Whether two edges of a closed polygon cross or touch that are not neighbours.
 * O(n^2). */
bool crossesItself(const std::vector<Eigen::Vector2d>& polygon);

/** @brief Fewest corners of a closed polygon such that no left-out corner is farther
 * than `tolerance` from it (Douglas and Peucker 1973). */
std::vector<Eigen::Vector2d> simplified(const std::vector<Eigen::Vector2d>& polygon,
                                        double tolerance);

/** @brief The same of an open line, which keeps both its ends. */
std::vector<Eigen::Vector2d> simplifiedLine(const std::vector<Eigen::Vector2d>& line,
                                            double tolerance);

} // namespace sedr
} // namespace pcl
