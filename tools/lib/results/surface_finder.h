// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/triangle_mesh.h>

#include <Eigen/Core>

#include <cstddef>
#include <limits>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief The triangle of a mesh that is nearest to a point. */
struct NearestTriangle {
  std::size_t triangle = 0;
  double distance = std::numeric_limits<double>::infinity(); ///< metres

  bool isFound() const { return distance < std::numeric_limits<double>::infinity(); }
};

/** @brief The point of a triangle that is nearest to `p`. */
Eigen::Vector3d nearestOnTriangle(const Eigen::Vector3d& p,
                                  const Eigen::Vector3d& a,
                                  const Eigen::Vector3d& b,
                                  const Eigen::Vector3d& c);

/** @brief Looks at every triangle: for a question now and then, as a click is; for
 * clouds there is MeshDistance. Of triangles at one distance, to a micrometre, the
 * first. */
NearestTriangle nearestTriangle(const TriangleMesh& mesh, const Eigen::Vector3d& p);

} // namespace tools
} // namespace sedr
} // namespace pcl
