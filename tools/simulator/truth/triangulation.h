// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulator/scan/vec.h"

#include <array>
#include <cstddef>
#include <vector>

namespace pcl::sedr::sim {

/** @brief Indices of points, in order around the polygon. */
using Ring = std::vector<std::size_t>;

/** @brief A polygon with a counter-clockwise outer ring and clockwise holes. */
struct Polygon {
  Ring outer;
  std::vector<Ring> holes;
};

using Triangle = std::array<std::size_t, 3>;

/** @brief Returns the signed area of a ring, positive for counter-clockwise ones. */
double areaOf(const std::vector<Vec2>& points, const Ring& ring);

/** @brief Groups rings (counter-clockwise: outer, clockwise: hole) into polygons.
 * @throw std::invalid_argument if a hole lies in no outer ring.
 */
std::vector<Polygon> polygonsOf(const std::vector<Vec2>& points,
                                const std::vector<Ring>& rings);

/** @brief Triangulates a polygon by ear clipping; clips the best-shaped ear first.
 *
 * Every edge of the rings is an edge of exactly one triangle, even where several points
 * are collinear. Neighbouring polygons therefore fit together. No points are added.
 * Cost: quadratic in the number of points.
 * @throw std::invalid_argument if the rings cross or touch.
 */
std::vector<Triangle> triangulate(const std::vector<Vec2>& points,
                                  const Polygon& polygon);

} // namespace pcl::sedr::sim
