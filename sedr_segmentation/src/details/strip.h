// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sedr_filters/src/grids/cell_mask.h"

#include <Eigen/Core>

namespace pcl::sedr {

/** @brief A strip of cells along a line; lengths in metres. */
struct Strip {
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  Eigen::Vector2d direction = Eigen::Vector2d::UnitX();
  double length = 0;
  double width = 0;
};

/** @brief Fits a straight strip to cells by their variance, l^2 / 12 for length l. The
 * length is 0 without cells. O(cells of the box). */
Strip stripOf(const CellMask& cells, const CellGrid& grid);

} // namespace pcl::sedr
