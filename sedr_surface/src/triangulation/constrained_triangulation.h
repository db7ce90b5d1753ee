// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan_grid.h"

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace pcl::sedr {

using PlanTriangles = std::vector<std::array<std::uint32_t, 3>>; ///< indices of points
using PlanEdges = std::vector<std::pair<std::uint32_t, std::uint32_t>>; ///< of points

/** @brief A triangulation of points in plan; triangles are counter-clockwise. */
struct PlanTriangulation {
  static constexpr std::uint32_t none = 0xffffffff;

  PlanTriangles triangles;
  /** @brief Triangle across the edge from corner i to corner i + 1, or none. */
  std::vector<std::array<std::uint32_t, 3>> neighbours;
};

/** @brief Computes the Delaunay triangulation of points, all distinct: triangles of
 * non-zero area, counter-clockwise, that fill their convex hull; none of points on a
 * line. O(n log n).
 * @return false if rounding has left gaps */
bool delaunay(const std::vector<GridPoint>& points, PlanTriangles& triangles);

/** @brief Triangulates the convex hull of `points` so that each of `edges` is a side of
 * triangles. Starts with Boost.Polygon's Delaunay triangulation. Sides that cross an
 * edge are swapped until none does; other sides are swapped to improve the triangles.
 *
 * All triangles have a non-zero area, and none contains another point, not even on its
 * sides.
 *
 * @param points all distinct
 * @param edges they may meet only at their ends and pass through no other point
 * @param[out] triangulation the result; empty if all points are collinear
 * @return false if an edge crosses another or passes through a point
 *
 * Deterministic. O(n log n) plus the swaps. */
bool triangulateConstrained(const std::vector<GridPoint>& points,
                            const PlanEdges& edges,
                            PlanTriangulation& triangulation);

/** @brief Triangulates an area: what an odd number of edges of its rim parts from the
 * outside. Points at which no edge ends are left out. O(n log n) plus the swaps.
 * @param rim as the edges of triangulateConstrained(), all distinct
 * @param folds further edges; none counts if one crosses another or passes through a
 * point
 * @return nothing if an edge of the rim does so */
std::optional<PlanTriangles> trianglesWithin(const std::vector<GridPoint>& points,
                                             const PlanEdges& rim,
                                             const PlanEdges& folds = {});

} // namespace pcl::sedr
