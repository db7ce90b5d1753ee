// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surface_cells.h"
#include <pcl/sedr_filters/vertical_hole_repair.h>

#include <vector>

namespace pcl {
namespace sedr {

/** @brief How much of a room's surfaces its scanned points do not support, at their own
 * density: an empty cell is unseen where no point of its surface is within the reach of
 * these points.
 *
 * Points of a square grid leave no place farther from all of them than half the
 * diagonal of a square. The reach is that of the square whose side is the distance
 * beyond which only one in twenty points of the room has its nearest neighbour on its
 * surface: of points that lie quite at random it leaves out a fifth of a surface, of
 * even ones nothing.
 *
 * @param cells of one room, occupied by its points
 * @param points that the sources of the cells are indices of
 *
 * O(c log c) for c cells. */
UnseenShares unseenSharesOf(const SurfaceCells& cells,
                            const std::vector<SurfacePoint>& points);

} // namespace sedr
} // namespace pcl
