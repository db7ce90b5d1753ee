// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "outline_walls.h"

#include <vector>

namespace pcl::sedr {

/** @brief Closes the notches of a room's outline that have no wall along them. There
 * the ceiling was hidden, possibly by a column close to the wall.
 * @param[in,out] columns gets such columns */
CellMask withoutFalseNotches(const CellMask& room,
                             const OutlineWalls& walls,
                             std::vector<CellMask>& columns);

} // namespace pcl::sedr
