// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/triangle_mesh.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief What is known of a vertex of a surface besides its place. */
struct SurfaceVertex {
  Eigen::Vector3f normal = Eigen::Vector3f::Zero(); ///< mean of the faces that meet
  Eigen::Vector3f line = Eigen::Vector3f::Zero();   ///< of the edge that it lies on
  std::uint8_t sharpness = 0; ///< 0 on a face, 1 at an edge, 2 at a corner
};

/** @brief Takes folds (triangles that face against the normals of their vertices) and
 * slivers out of a closed manifold surface, by collapsing short edges and shifting
 * vertices; it stays closed and manifold. Of two vertices the sharper one stays where
 * it is.
 *
 * @param vertices what is known of each vertex of the mesh
 * @param least_height triangles of less height are slivers
 * @param longest edges to collapse
 * @return the number of edges collapsed
 *
 * O(n), in one order. */
std::size_t mendSurface(TriangleMesh& mesh,
                        std::vector<SurfaceVertex>& vertices,
                        double least_height,
                        double longest);

} // namespace sedr
} // namespace pcl
