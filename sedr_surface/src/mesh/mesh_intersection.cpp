// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_repair.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace pcl::sedr {

namespace {

using Corners = std::array<Eigen::Vector3d, 3>;

Corners
cornersOf(const TriangleMesh& mesh, std::uint32_t t)
{
  return {mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)};
}

/** @brief Returns the distance of a point in a triangle's plane from the nearest side,
 * metres; negative outside. */
double
depthWithin(const Corners& triangle,
            const Eigen::Vector3d& normal,
            const Eigen::Vector3d& p)
{
  double depth = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector3d side = triangle[(i + 1) % 3] - triangle[i];
    depth = std::min(depth, normal.cross(side).dot(p - triangle[i]) / side.norm());
  }
  return depth;
}

/** @brief Returns whether the segment from p to q passes through a triangle. */
bool
pierces(const Eigen::Vector3d& p,
        const Eigen::Vector3d& q,
        const Corners& triangle,
        const Eigen::Vector3d& normal,
        double tolerance)
{
  const double at_p = normal.dot(p - triangle[0]);
  const double at_q = normal.dot(q - triangle[0]);
  if (std::min(at_p, at_q) > -tolerance || std::max(at_p, at_q) < tolerance)
    return false;
  return depthWithin(triangle, normal, p + (q - p) * (at_p / (at_p - at_q))) >
         tolerance;
}

/** @brief Returns whether two coplanar triangles share an area: no side of either
 * separates them. */
bool
overlap(const Corners& a,
        const Corners& b,
        const Eigen::Vector3d& normal,
        double tolerance)
{
  const auto isParted = [&](const Corners& from, const Corners& other, double sense) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Eigen::Vector3d side = from[(i + 1) % 3] - from[i];
      const Eigen::Vector3d inward = sense * normal.cross(side).normalized();
      if (std::all_of(other.begin(), other.end(), [&](const Eigen::Vector3d& p) {
            return inward.dot(p - from[i]) < tolerance;
          }))
        return true;
    }
    return false;
  };
  const double sense_of_b =
      (b[1] - b[0]).cross(b[2] - b[0]).dot(normal) > 0 ? 1.0 : -1.0;
  return !isParted(a, b, 1) && !isParted(b, a, sense_of_b);
}

bool
meet(const Corners& a, const Corners& b, double tolerance)
{
  const Eigen::Vector3d normal_a = (a[1] - a[0]).cross(a[2] - a[0]).normalized();
  const Eigen::Vector3d normal_b = (b[1] - b[0]).cross(b[2] - b[0]).normalized();
  const auto isInPlane = [&](const Eigen::Vector3d& p) {
    return std::abs(normal_a.dot(p - a[0])) <= tolerance;
  };
  if (std::all_of(b.begin(), b.end(), isInPlane))
    return overlap(a, b, normal_a, tolerance);
  for (std::size_t i = 0; i < 3; ++i)
    if (pierces(a[i], a[(i + 1) % 3], b, normal_b, tolerance) ||
        pierces(b[i], b[(i + 1) % 3], a, normal_a, tolerance))
      return true;
  return false;
}

} // namespace

std::vector<std::pair<std::uint32_t, std::uint32_t>>
findSelfIntersections(const TriangleMesh& mesh, double tolerance, std::size_t most)
{
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  if (mesh.empty())
    return pairs;
  Eigen::Index axis = 0;
  mesh.bounds().sizes().maxCoeff(&axis);
  std::vector<Eigen::AlignedBox3d> boxes(mesh.triangles.size());
  for (std::size_t t = 0; t < boxes.size(); ++t)
    for (int i = 0; i < 3; ++i)
      boxes[t].extend(mesh.corner(t, i));
  std::vector<std::uint32_t> order(mesh.triangles.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t t, std::uint32_t u) {
    return std::make_pair(boxes[t].min()[axis], t) <
           std::make_pair(boxes[u].min()[axis], u);
  });
  for (std::size_t i = 0; i < order.size() && pairs.size() < most; ++i)
    for (std::size_t j = i + 1;
         j < order.size() && boxes[order[j]].min()[axis] <= boxes[order[i]].max()[axis];
         ++j) {
      const auto pair = std::minmax(order[i], order[j]);
      if (!boxes[pair.first].intersects(boxes[pair.second]) ||
          !meet(cornersOf(mesh, pair.first), cornersOf(mesh, pair.second), tolerance))
        continue;
      pairs.emplace_back(pair);
      if (pairs.size() >= most)
        break;
    }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

} // namespace pcl::sedr
