// SPDX-License-Identifier: BSD-3-Clause
#include "surface_finder.h"

#include <algorithm>

namespace pcl::sedr::tools {

namespace {

constexpr double same_distance = 1e-6; // metres

Eigen::Vector3d
nearestOnSegment(const Eigen::Vector3d& p,
                 const Eigen::Vector3d& a,
                 const Eigen::Vector3d& b)
{
  const Eigen::Vector3d way = b - a;
  const double square = way.squaredNorm();
  const double share = square > 0 ? (p - a).dot(way) / square : 0;
  return a + std::clamp(share, 0.0, 1.0) * way;
}

} // namespace

Eigen::Vector3d
nearestOnTriangle(const Eigen::Vector3d& p,
                  const Eigen::Vector3d& a,
                  const Eigen::Vector3d& b,
                  const Eigen::Vector3d& c)
{
  const Eigen::Vector3d normal = (b - a).cross(c - a);
  const auto isLeftOf = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    return normal.dot((to - from).cross(p - from)) >= 0;
  };
  if (normal.squaredNorm() > 0 && isLeftOf(a, b) && isLeftOf(b, c) && isLeftOf(c, a))
    return p - normal * ((p - a).dot(normal) / normal.squaredNorm());
  Eigen::Vector3d nearest = nearestOnSegment(p, a, b);
  for (const Eigen::Vector3d& other :
       {nearestOnSegment(p, b, c), nearestOnSegment(p, c, a)})
    if ((p - other).squaredNorm() < (p - nearest).squaredNorm())
      nearest = other;
  return nearest;
}

NearestTriangle
nearestTriangle(const TriangleMesh& mesh, const Eigen::Vector3d& p)
{
  NearestTriangle nearest;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const double distance =
        (nearestOnTriangle(p, mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)) -
         p)
            .norm();
    if (distance < nearest.distance - same_distance)
      nearest = {t, distance};
  }
  return nearest;
}

} // namespace pcl::sedr::tools
