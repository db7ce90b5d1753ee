// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/triangle_mesh.h>

#include <cstddef>

namespace pcl {
namespace sedr {

/** @brief Makes one vertex of those at equal positions. Triangles may become
 * degenerate. O(n log n).
 * @return the number of vertices that joined another */
std::size_t weldVertices(TriangleMesh& mesh);

/** @brief Moves vertices apart that are at equal positions, as those of two sheets are
 * that both follow one edge: afterwards no two are, also in a file of floats, and a
 * reader that welds equal positions joins no sheets.
 *
 * All positions become what a float holds of them. Of several vertices in one place
 * the first stays; each other one goes 2 % of the way to the middle of its own
 * triangles, or farther or towards one of them where that place is taken. O(n log n).
 * @return the number of vertices moved */
std::size_t partEqualPositions(TriangleMesh& mesh);

/** @brief What keepLargestComponent() took away. */
struct RemovedComponents {
  std::size_t components = 0;
  std::size_t triangles = 0; ///< of these components
};

/** @brief Keeps the component of the largest area. O(n). */
RemovedComponents keepLargestComponent(TriangleMesh& mesh);

} // namespace sedr
} // namespace pcl
