// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "storey_lines.h"

#include <vector>

namespace pcl::sedr {

/** @brief Cells of a room that lie in openings and niches of its walls: seen air behind
 * the line of a wall, no deeper than a wall is thick. */
struct RecessCells {
  CellMask open;   ///< behind them is glass, daylight, another room, or a leaf
  CellMask closed; ///< they have an opaque back, deeper than leaves and blinds are
};

/** @brief Looks behind the lines of a storey, for each of its rooms. O(cells beside
 * lines).
 * @param max_depth of what is before no other room, metres
 * @return by room */
std::vector<RecessCells> recessCells(const Storey& storey,
                                     const std::vector<RoomCells>& cells,
                                     const std::vector<StoreyLine>& lines,
                                     const CellGrid& grid,
                                     double max_depth);

} // namespace pcl::sedr
