// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/triangle_mesh.h>

#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

namespace pcl::sedr {

/** @brief Finds pairs of triangles that intersect or overlap, whatever their
 * connectivity. A valid solid has none.
 *
 * @param mesh must be valid (TriangleMesh::problem() empty)
 * @param tolerance metres above 0; shallower intersections count as rounding. For
 * floats from files, 1e-5 for coordinates up to 100 m
 * @param most maximum number of pairs
 * @return indices of two triangles each, the lower first, sorted
 *
 * Triangles are swept along the longest axis of the mesh: some seconds for 200000 small
 * ones. Deterministic. */
std::vector<std::pair<std::uint32_t, std::uint32_t>>
findSelfIntersections(const TriangleMesh& mesh,
                      double tolerance = 1e-6,
                      std::size_t most = 1000);

using MeshEdge = std::pair<std::uint32_t, std::uint32_t>; ///< directed

/** @brief Returns the edges of triangles that none of them has in the opposite
 * direction. O(n log n). */
std::set<MeshEdge> rimOf(const std::vector<Triangle>& triangles);

/** @brief Merges vertices at equal positions. Triangles may become degenerate. O(n log
 * n).
 * @return the number of vertices merged into another */
std::size_t weldVertices(TriangleMesh& mesh);

/** @brief Moves vertices at equal positions apart, such as those of two sheets along
 * one edge. Afterwards all positions differ, even in a file of floats, so that readers
 * that weld equal positions join no sheets.
 *
 * All positions are rounded to float. Of several vertices at one position the first
 * stays. Each other one moves 2 % towards the centre of its triangles, or farther if
 * that position is taken. O(n log n).
 * @return the number of vertices moved */
std::size_t partEqualPositions(TriangleMesh& mesh);

/** @brief What keepLargestComponent() removed. */
struct RemovedComponents {
  std::size_t components = 0;
  std::size_t triangles = 0; ///< triangles of these components
};

/** @brief Keeps only the component with the largest area. O(n). */
RemovedComponents keepLargestComponent(TriangleMesh& mesh);

} // namespace pcl::sedr
