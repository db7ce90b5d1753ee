// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulator/scan/vec.h"

#include <array>
#include <cstddef>
#include <vector>

namespace pcl::sedr::sim {

/** @brief Indices of points, in order around an area. */
using Ring = std::vector<std::size_t>;

using Triangle = std::array<std::size_t, 3>;

/** @brief Triangulates the areas to the left of rings: inside of counter-clockwise
 * rings, outside of clockwise ones, which are holes.
 *
 * Every edge of the rings is an edge of exactly one triangle, even where several points
 * are collinear. Neighbouring areas therefore fit together. No points are added.
 * @param points only those of the rings matter
 * @throw std::invalid_argument if rings cross or touch, or a hole lies in no ring. */
std::vector<Triangle> triangulate(const std::vector<Vec2>& points,
                                  const std::vector<Ring>& rings);

} // namespace pcl::sedr::sim
