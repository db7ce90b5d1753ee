// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/triangle_mesh.h>

#include <Eigen/Core>

#include <cstddef>
#include <limits>

namespace pcl::sedr::tools {

/** @brief The triangle of a mesh nearest to a point. */
struct NearestTriangle {
  std::size_t triangle = 0;
  double distance = std::numeric_limits<double>::infinity(); ///< metres

  bool isFound() const { return distance < std::numeric_limits<double>::infinity(); }
};

/** @brief Returns the point of a triangle nearest to `p`. */
Eigen::Vector3d nearestOnTriangle(const Eigen::Vector3d& p,
                                  const Eigen::Vector3d& a,
                                  const Eigen::Vector3d& b,
                                  const Eigen::Vector3d& c);

/** @brief Finds the nearest triangle by testing all, for single queries such as a
 * click; for clouds use MeshDistance. Of triangles at equal distance, to a micrometre,
 * the first. */
NearestTriangle nearestTriangle(const TriangleMesh& mesh, const Eigen::Vector3d& p);

} // namespace pcl::sedr::tools
