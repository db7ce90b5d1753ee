// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "panel.h"

#include <pcl/sedr_filters/cell_grid.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/types.h>

#include <string>
#include <vector>

namespace pcl::sedr::tools {

/** @brief Returns the label position of a set of cells: a cell deep inside and near
 * their mean, metres. The set must not be empty. */
Eigen::Vector2d labelPlace(const CellSet& cells, double cell_size);

/** @brief Adds all cells of `more` to `cells`. */
void addTo(CellSet& cells, const CellSet& more);

/** @brief Returns the finite points in plan. */
std::vector<Eigen::Vector2d> placesOf(const PointView& points,
                                      const pcl::Indices& indices);

/** @brief Returns the ceiling shade for a room; neighbouring numbers differ. */
Colour ceilingShade(std::size_t room);

/** @brief Formats a count: "1 room", "3 rooms". */
std::string counted(std::size_t number, const std::string& thing);

} // namespace pcl::sedr::tools
