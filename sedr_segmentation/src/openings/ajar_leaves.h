// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "opening_weights.h"
#include "wall_sides.h"

#include <vector>

namespace pcl::sedr {

/** @brief Takes from the points before a wall, and on it, those of leaves that stand
 * ajar: from its hinge on the distance of a leaf from the face grows evenly, so what it
 * hides is no wall. It is as long as a door is wide, and as high. Beyond its hinge the
 * face goes on: the opening of a leaf that stands wide open is there instead.
 * O(n log n + n x leaves).
 * @param cell width of the columns whose distances from the face are compared, metres
 * @return the points that were taken */
std::vector<SidePoint> takeAjarLeaves(std::vector<SidePoint>& points,
                                      const WallSide& side,
                                      double cell,
                                      const OpeningSizes& sizes);

} // namespace pcl::sedr
