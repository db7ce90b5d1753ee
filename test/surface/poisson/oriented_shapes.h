// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/impl/room_samples.h>

#include <cmath>
#include <vector>

namespace sedr_test {

/** Points of a sphere in a spiral, `spacing` apart, normals outwards. */
inline std::vector<pcl::sedr::OrientedPoint>
sphere(const Eigen::Vector3d& centre, double radius, double spacing)
{
  const double area = 4 * M_PI * radius * radius;
  const auto n = static_cast<int>(area / (spacing * spacing));
  std::vector<pcl::sedr::OrientedPoint> points;
  for (int i = 0; i < n; ++i) {
    const double z = 1 - (2 * i + 1) / static_cast<double>(n);
    const double turn = 2.399963229728653 * i; // the golden angle
    const double r = std::sqrt(1 - z * z);
    const Eigen::Vector3d normal(r * std::cos(turn), r * std::sin(turn), z);
    points.push_back({(centre + radius * normal).cast<float>(), normal.cast<float>()});
  }
  return points;
}

/** Points of a box with a corner at the origin, normals outwards. */
inline std::vector<pcl::sedr::OrientedPoint>
box(const Eigen::Vector3d& size, double spacing)
{
  std::vector<pcl::sedr::OrientedPoint> points;
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    const auto nu = static_cast<int>(std::lround(size[u] / spacing));
    const auto nv = static_cast<int>(std::lround(size[v] / spacing));
    for (int i = 0; i < nu; ++i)
      for (int j = 0; j < nv; ++j)
        for (int side = 0; side < 2; ++side) {
          Eigen::Vector3d place;
          place[axis] = side * size[axis];
          place[u] = (i + 0.5) * size[u] / nu;
          place[v] = (j + 0.5) * size[v] / nv;
          points.push_back(
              {place.cast<float>(), Eigen::Vector3f::Unit(axis) * (side ? 1.f : -1.f)});
        }
  }
  return points;
}

} // namespace sedr_test
