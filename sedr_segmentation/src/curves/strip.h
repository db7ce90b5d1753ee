// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sedr_filters/src/grids/cell_mask.h"

#include <Eigen/Core>

#include <functional>

namespace pcl {
namespace sedr {

/** @brief A strip of cells along a line; lengths in metres. */
struct Strip {
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  Eigen::Vector2d direction = Eigen::Vector2d::UnitX();
  double length = 0;
  double width = 0;
};

/** @brief The straight strip that cells spread along: one of length l has the variance
 * l^2 / 12. No cells give one of length 0. O(cells of the box). */
Strip stripOf(const CellMask& cells, const CellGrid& grid);

/** @brief Whether a wall goes on in line with a strip, 0.15 to 0.3 m beyond one of its
 * ends.
 * @param is_wall says it of a cell */
bool wallGoesOn(const Strip& strip,
                const CellGrid& grid,
                const std::function<bool(Cell)>& is_wall);

} // namespace sedr
} // namespace pcl
