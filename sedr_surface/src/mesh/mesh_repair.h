// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/triangle_mesh.h>

#include <cstddef>

namespace pcl::sedr {

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
