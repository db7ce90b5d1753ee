// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "opening_weights.h"
#include "wall_sides.h"

#include <vector>

namespace pcl::sedr {

/** @brief Takes from the points before a wall, and on it, those of leaves that stand
 * ajar: from its hinge on the distance of a leaf from the face grows evenly, so what it
 * hides is no wall. It is as long as a door is wide, and as high. Lengths in metres.
 * O(n log n + n x leaves).
 * @param length of the wall
 * @param cell width of the columns whose distances from the face are compared
 * @param floor z
 * @return the points that were taken */
std::vector<SidePoint> takeAjarLeaves(std::vector<SidePoint>& points,
                                      double length,
                                      double cell,
                                      double floor,
                                      const OpeningSizes& sizes);

} // namespace pcl::sedr
