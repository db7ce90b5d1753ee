// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/triangle_mesh.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Triangles that hang together across their edges. */
struct MeshComponent {
  std::size_t triangles = 0;
  double area = 0;          ///< square metres
  double signed_volume = 0; ///< cubic metres; negative if the normals point inwards
  bool closed = false;      ///< none of its edges has one triangle only
};

/** @brief How the triangles of a mesh hang together, told by their indices alone: two
 * vertices at the same place are two vertices (see weldVertices). */
struct MeshTopology {
  std::size_t vertices = 0;        ///< used by a triangle
  std::size_t unused_vertices = 0; ///< used by none
  std::size_t edges = 0;
  std::size_t triangles = 0;
  std::size_t degenerate_triangles = 0; ///< that use a vertex twice
  std::size_t zero_area_triangles = 0;  ///< three vertices, but no area
  std::size_t duplicate_triangles = 0; ///< over vertices that an earlier triangle spans
  std::size_t boundary_edges = 0;      ///< with one triangle
  std::size_t non_manifold_edges = 0;  ///< with three or more
  std::size_t inconsistent_edges = 0;  ///< with two that run along it in the same sense
  std::size_t non_manifold_vertices = 0; ///< whose triangles form more than one fan
  std::int64_t euler_characteristic = 0; ///< vertices - edges + triangles
  std::vector<MeshComponent> components; ///< largest area first

  /** @brief No edge with one triangle only. */
  bool isClosed() const { return triangles > 0 && boundary_edges == 0; }

  /** @brief No edge with three or more triangles. */
  bool isEdgeManifold() const { return non_manifold_edges == 0; }

  /** @brief No vertex whose triangles form more than one fan. */
  bool isVertexManifold() const { return non_manifold_vertices == 0; }

  /** @brief Neighbouring triangles agree on which side is which. */
  bool isOriented() const { return inconsistent_edges == 0; }

  /** @brief Closed, manifold at edges and vertices, consistently oriented, and no
   * triangle that uses a vertex twice or doubles another: the boundary of a solid. */
  bool isClosedManifold() const
  {
    return isClosed() && isEdgeManifold() && isVertexManifold() && isOriented() &&
           degenerate_triangles == 0 && duplicate_triangles == 0;
  }

  /** @brief What keeps it from isClosedManifold(), for people: "12 boundary edges, 3
   * non-manifold edges"; empty if nothing does. */
  std::string problem() const;
};

/** @brief Looks how the triangles of `mesh` hang together.
 *
 * Triangles hang together where they share an edge; two cubes that touch at a vertex
 * are two components with one non-manifold vertex. The mesh must be one
 * (TriangleMesh::problem() empty). O(n log n) in the triangles, and as deterministic as
 * counting is. */
MeshTopology checkTopology(const TriangleMesh& mesh);

/** @brief The component of every triangle, counted from 0 in the order of the first
 * triangle of each. */
std::vector<std::uint32_t> labelComponents(const TriangleMesh& mesh);

} // namespace sedr
} // namespace pcl
