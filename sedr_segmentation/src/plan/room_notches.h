// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "outline_walls.h"

#include <vector>

namespace pcl {
namespace sedr {

/** @brief A room without the notches of its outline along which no wall stands:
 * something hid the ceiling there, a column just off the wall perhaps.
 * @param columns those columns are added to it */
CellMask withoutFalseNotches(const CellMask& room,
                             const OutlineWalls& walls,
                             std::vector<CellMask>& columns);

} // namespace sedr
} // namespace pcl
