// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../solid/plan_grid.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief A triangulation of points in plan, each triangle counter-clockwise. */
struct PlanTriangulation {
  static constexpr std::uint32_t none = 0xffffffff;

  std::vector<std::array<std::uint32_t, 3>> triangles; ///< indices of points
  /** @brief The triangle across the edge from corner i to corner i + 1, or none. */
  std::vector<std::array<std::uint32_t, 3>> neighbours;
};

/** @brief Triangulates the convex hull of `points` so that every one of `edges` is a
 * side of triangles: Boost.Polygon's Delaunay triangulation, in which sides that cross
 * an edge are swapped until none does, and others where that makes the triangles
 * better.
 *
 * No triangle is without area, and none holds a point, on its sides included.
 *
 * @param points no two the same
 * @param edges indices of two points each; they may meet in their ends only and pass
 * through no other point
 * @param[out] triangulation the result; empty where all points lie on one line
 * @return false if an edge cannot be had, since it crosses another or passes through a
 * point
 *
 * Deterministic. O(n log n) and what the swaps take. */
bool triangulateConstrained(
    const std::vector<GridPoint>& points,
    const std::vector<std::pair<std::uint32_t, std::uint32_t>>& edges,
    PlanTriangulation& triangulation);

} // namespace sedr
} // namespace pcl
