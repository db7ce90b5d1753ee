// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/triangle_mesh.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief A set of triangles connected across shared edges. */
struct MeshComponent {
  std::size_t triangles = 0;
  double area = 0;          ///< square metres
  double signed_volume = 0; ///< cubic metres; negative if the normals point inwards
  bool closed = false;      ///< no edge has only one triangle
};

/** @brief The connectivity of a mesh, from indices alone: two vertices at the same
 * place are distinct (see weldVertices). */
struct MeshTopology {
  std::size_t vertices = 0; ///< used by triangles
  std::size_t edges = 0;
  std::size_t triangles = 0;
  std::size_t degenerate_triangles = 0;  ///< triangles that use a vertex twice
  std::size_t duplicate_triangles = 0;   ///< with the vertices of an earlier one
  std::size_t boundary_edges = 0;        ///< edges with one triangle
  std::size_t non_manifold_edges = 0;    ///< edges with three or more
  std::size_t inconsistent_edges = 0;    ///< traversed twice in one direction
  std::size_t non_manifold_vertices = 0; ///< with more than one fan of triangles
  std::int64_t euler_characteristic = 0; ///< vertices - edges + triangles
  std::vector<MeshComponent> components; ///< largest area first

  /** @brief Returns true if no edge has only one triangle. */
  bool isClosed() const { return triangles > 0 && boundary_edges == 0; }

  /** @brief Returns true if the mesh bounds a solid: closed, manifold at edges and
   * vertices, consistently oriented, without degenerate or duplicate triangles. */
  bool isClosedManifold() const
  {
    return isClosed() && non_manifold_edges == 0 && non_manifold_vertices == 0 &&
           inconsistent_edges == 0 && degenerate_triangles == 0 &&
           duplicate_triangles == 0;
  }

  /** @brief Returns for users why isClosedManifold() is false: "12 boundary edges, 3
   * non-manifold edges"; empty if it is true. */
  std::string problem() const;
};

/** @brief Computes the connectivity of `mesh`.
 *
 * Triangles are connected where they share an edge. Two cubes that touch at a vertex
 * are two components with one non-manifold vertex. The mesh must be valid
 * (TriangleMesh::problem() empty). O(n log n) for n triangles; deterministic. */
MeshTopology checkTopology(const TriangleMesh& mesh);

/** @brief Returns the component of every triangle. Components are numbered from 0 in
 * the order of their first triangles. */
std::vector<std::uint32_t> labelComponents(const TriangleMesh& mesh);

} // namespace pcl::sedr
