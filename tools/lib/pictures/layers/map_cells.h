// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "canvas.h"
#include "panel.h"

#include <pcl/sedr_filters/cell_grid.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/types.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief Where the name of a set of cells stands: a cell deep inside and near their
 * mean, metres. The set must not be empty. */
Eigen::Vector2d labelPlace(const CellSet& cells, double cell_size);

/** @brief Adds all of `more` to `cells`. */
void addTo(CellSet& cells, const CellSet& more);

/** @brief Where points are in plan. Non-finite ones are left out. */
std::vector<Eigen::Vector2d> placesOf(const PointView& points,
                                      const pcl::Indices& indices);

/** @brief A colour of its own for each number, from 0; after a dozen they come again.
 */
Colour colourNumber(std::size_t number);

/** @brief A shade of the ceiling's colour for each room, so that neighbours differ. */
Colour ceilingShade(std::size_t room);

/** @brief "1 room", "3 rooms". */
std::string counted(std::size_t number, const std::string& thing);

} // namespace tools
} // namespace sedr
} // namespace pcl
