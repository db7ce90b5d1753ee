// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan_grid.h"

#include <array>
#include <cstdint>
#include <vector>

namespace pcl::sedr {

using PlanTriangles = std::vector<std::array<std::uint32_t, 3>>; ///< indices of points

/** @brief Computes the Delaunay triangulation of points, all distinct: triangles of
 * non-zero area, counter-clockwise, that fill their convex hull; none of points on a
 * line. O(n log n).
 * @return false if rounding has left gaps */
bool delaunay(const std::vector<GridPoint>& points, PlanTriangles& triangles);

} // namespace pcl::sedr
