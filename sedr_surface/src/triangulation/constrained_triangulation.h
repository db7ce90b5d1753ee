// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "delaunay.h"
#include "plan_grid.h"

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace pcl::sedr {

/** @brief A triangulation of points in plan; triangles are counter-clockwise. */
struct PlanTriangulation {
  static constexpr std::uint32_t none = 0xffffffff;

  std::vector<std::array<std::uint32_t, 3>> triangles; ///< indices of points
  /** @brief Triangle across the edge from corner i to corner i + 1, or none. */
  std::vector<std::array<std::uint32_t, 3>> neighbours;
};

/** @brief Triangulates the convex hull of `points` so that each of `edges` is a side of
 * triangles. Starts with Boost.Polygon's Delaunay triangulation. Sides that cross an
 * edge are swapped until none does; other sides are swapped to improve the triangles.
 *
 * All triangles have a non-zero area, and none contains another point, not even on its
 * sides.
 *
 * @param points all distinct
 * @param edges indices of two points each; they may meet only at their ends and pass
 * through no other point
 * @param[out] triangulation the result; empty if all points are collinear
 * @return false if an edge crosses another or passes through a point
 *
 * Deterministic. O(n log n) plus the swaps. */
bool triangulateConstrained(
    const std::vector<GridPoint>& points,
    const std::vector<std::pair<std::uint32_t, std::uint32_t>>& edges,
    PlanTriangulation& triangulation);

/** @brief Returns which triangles lie inside the area enclosed by edges: those that an
 * odd number of them parts from the outside. O(n log n).
 * @param edges sides of triangles, indices of two points each, all distinct */
std::vector<bool> insideOf(const PlanTriangulation& triangulation,
                           std::vector<std::pair<std::uint32_t, std::uint32_t>> edges);

/** @brief Triangulates the area that a rim encloses.
 * @param edges sides of triangles as for triangulateConstrained(), among them the rim
 * @param rim as for insideOf()
 * @return nothing if an edge crosses another or passes through a point */
std::optional<PlanTriangles>
trianglesWithin(const std::vector<GridPoint>& points,
                const std::vector<std::pair<std::uint32_t, std::uint32_t>>& edges,
                const std::vector<std::pair<std::uint32_t, std::uint32_t>>& rim);

} // namespace pcl::sedr
