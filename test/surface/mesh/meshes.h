// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/triangle_mesh.h>

#include <cmath>

namespace sedr_test {

using pcl::sedr::TriangleMesh;

/** A box with normals outwards: 8 vertices, 12 triangles. */
inline TriangleMesh
box(const Eigen::Vector3d& low, const Eigen::Vector3d& high)
{
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.vertices.emplace_back(i & 1 ? high.x() : low.x(), i & 2 ? high.y() : low.y(),
                               i & 4 ? high.z() : low.z());
  mesh.triangles = {{0, 2, 3}, {0, 3, 1},  // bottom
                    {4, 5, 7}, {4, 7, 6},  // top
                    {0, 1, 5}, {0, 5, 4},  // front
                    {2, 6, 7}, {2, 7, 3},  // back
                    {0, 4, 6}, {0, 6, 2},  // left
                    {1, 3, 7}, {1, 7, 5}}; // right
  return mesh;
}

inline TriangleMesh
unitCube()
{
  return box({0, 0, 0}, {1, 1, 1});
}

/** Returns a grid of n by m quads, closed in both directions, with vertices
 * `position(u, v)`. */
template <typename Position>
TriangleMesh
closedGrid(std::uint32_t n, std::uint32_t m, Position position)
{
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < m; ++j)
      mesh.vertices.push_back(position(2 * M_PI * i / n, 2 * M_PI * j / m));
  const auto at = [n, m](std::uint32_t i, std::uint32_t j) {
    return i % n * m + j % m;
  };
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < m; ++j) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return mesh;
}

/** A torus of radii 2 and 0.5, normals outwards. */
inline TriangleMesh
torus()
{
  return closedGrid(24, 12, [](double u, double v) {
    const double r = 2 + 0.5 * std::cos(v);
    return Eigen::Vector3d(r * std::cos(u), r * std::sin(u), 0.5 * std::sin(v));
  });
}

/** A sphere made of an octahedron with each face split into n * n. */
inline TriangleMesh
sphere(const Eigen::Vector3d& centre, double radius, int n)
{
  TriangleMesh mesh;
  for (int octant = 0; octant < 8; ++octant) {
    const Eigen::Vector3d x((octant & 1) ? -1 : 1, 0, 0);
    const Eigen::Vector3d y(0, (octant & 2) ? -1 : 1, 0);
    const Eigen::Vector3d z(0, 0, (octant & 4) ? -1 : 1);
    const bool mirrored = x.cross(y).dot(z) < 0;
    const auto vertex = [&](int i, int j) {
      const Eigen::Vector3d p = (x * i + y * j + z * (n - i - j)).normalized();
      mesh.vertices.push_back(centre + radius * p);
      return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
    };
    const auto triangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      mesh.triangles.push_back({a, mirrored ? c : b, mirrored ? b : c});
    };
    for (int i = 0; i < n; ++i)
      for (int j = 0; i + j < n; ++j) {
        triangle(vertex(i, j), vertex(i + 1, j), vertex(i, j + 1));
        if (i + j + 2 <= n)
          triangle(vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1));
      }
  }
  return mesh; // each triangle has vertices of its own, which must be welded
}

inline TriangleMesh
both(TriangleMesh a, const TriangleMesh& b)
{
  a.append(b);
  return a;
}

} // namespace sedr_test
