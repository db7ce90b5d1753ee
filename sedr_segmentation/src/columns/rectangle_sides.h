// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "column_rectangle.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief A value below which a share of the sorted values lies. */
double quantile(const std::vector<double>& sorted, double share);

/** @brief Where the points of a side end. A point stands for those of a voxel, so that
 * the last is short of the end. */
double endOf(const std::vector<double>& sorted, bool is_high, double voxel);

/** @brief Values around which many of the sorted ones are: places of sides. */
std::vector<double> peaksOf(std::vector<double> sorted, double width);

/** @brief The points of each side, those near a corner left out. */
std::array<std::vector<Eigen::Vector2d>, 4>
pointsOfSides(const std::vector<Eigen::Vector2d>& in_frame,
              const Rectangle& rectangle,
              double band);

/** @brief Puts sides that no points show where the points beside them end, and says
 * how well the others are shown. */
void
judgeSides(const std::vector<Eigen::Vector2d>& in_frame, double band, Rectangle& r);

} // namespace sedr
} // namespace pcl
