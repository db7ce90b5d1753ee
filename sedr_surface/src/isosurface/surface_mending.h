// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/triangle_mesh.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief Properties of a surface vertex besides its position. */
struct SurfaceVertex {
  Eigen::Vector3f normal = Eigen::Vector3f::Zero(); ///< mean of the faces that meet
  Eigen::Vector3f line = Eigen::Vector3f::Zero();   ///< direction of its edge
  std::uint8_t sharpness = 0; ///< 0 on a face, 1 at an edge, 2 at a corner
};

/** @brief Removes folds (triangles that face against the normals of their vertices) and
 * slivers from a closed manifold surface by edge collapses and flips. The
 * surface stays closed and manifold. In a collapse, the sharper vertex stays in place.
 *
 * @param vertices properties of each vertex of the mesh
 * @param min_height slivers are triangles of less height
 * @param longest maximum length of edges to collapse
 * @return the number of collapsed edges
 *
 * O(n), in a fixed order. */
std::size_t mendSurface(TriangleMesh& mesh,
                        std::vector<SurfaceVertex>& vertices,
                        double min_height,
                        double longest);

} // namespace pcl::sedr
