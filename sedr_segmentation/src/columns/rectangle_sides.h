// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "column_rectangle.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace pcl::sedr {

/** @brief Returns the quantile of sorted values. */
double quantile(const std::vector<double>& sorted, double share);

/** @brief Returns the end of a side from its points. Points are voxel means, so the
 * last one lies short of the end. */
double endOf(const std::vector<double>& sorted, bool is_high, double voxel);

/** @brief Returns the peaks of the density of sorted values: the positions of sides. */
std::vector<double> peaksOf(std::vector<double> sorted, double width);

/** @brief Returns the points of each side, without those near a corner. */
std::array<std::vector<Eigen::Vector2d>, 4>
pointsOfSides(const std::vector<Eigen::Vector2d>& in_frame,
              const Rectangle& rectangle,
              double band);

/** @brief Moves sides without points to the end of the points of adjacent sides, and
 * sets inliers and residuals of the others. */
void
judgeSides(const std::vector<Eigen::Vector2d>& in_frame, double band, Rectangle& r);

} // namespace pcl::sedr
