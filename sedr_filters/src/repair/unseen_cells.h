// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surface_cells.h"
#include <pcl/sedr_filters/vertical_hole_repair.h>

#include <vector>

namespace pcl::sedr {

/** @brief Computes the share of a room's surfaces without support by scanned points, at
 * their own density. An empty cell is unseen if no point of its surface lies within the
 * reach.
 *
 * In a square grid of points no place is farther from all points than half the diagonal
 * of a square. The reach is this half diagonal, with the 95th percentile of the
 * distances between nearest neighbours on a surface as the side. Random points leave a
 * fifth of a surface unseen, evenly spaced ones nothing.
 *
 * @param cells cells of one room, occupied by its points
 * @param points the points that the sources of the cells refer to
 *
 * O(c log c) for c cells. */
UnseenShares unseenSharesOf(const SurfaceCells& cells,
                            const std::vector<SurfacePoint>& points,
                            unsigned threads);

} // namespace pcl::sedr
