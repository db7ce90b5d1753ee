// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_repair.h"

#include <pcl/sedr_surface/triangle_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

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

namespace {

/** @brief Returns for each vertex the first one at the same position. */
std::vector<std::uint32_t>
firstAtPosition(const std::vector<Eigen::Vector3d>& vertices)
{
  std::vector<std::uint32_t> order(vertices.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto key = [&vertices](std::uint32_t v) {
    return std::make_tuple(vertices[v].x(), vertices[v].y(), vertices[v].z());
  };
  std::sort(order.begin(), order.end(), [&key](std::uint32_t a, std::uint32_t b) {
    return key(a) != key(b) ? key(a) < key(b) : a < b;
  });
  std::vector<std::uint32_t> first(vertices.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool is_equal = i > 0 && key(order[i]) == key(order[i - 1]);
    first[order[i]] = is_equal ? first[order[i - 1]] : order[i];
  }
  return first;
}

using Position = std::array<float, 3>;

Position
rounded(const Eigen::Vector3d& v)
{
  return {static_cast<float>(v.x()), static_cast<float>(v.y()),
          static_cast<float>(v.z())};
}

/** @brief Returns a free position a little along a direction, farther if taken. If the
 * direction is too short for a float, the next value of x. */
Position
freePosition(const Eigen::Vector3d& from,
             const Eigen::Vector3d& along,
             const std::set<Position>& taken)
{
  for (double share = 0.02; share < 0.5; share *= 2)
    if (const Position place = rounded(from + share * along); taken.count(place) == 0)
      return place;
  Position place = rounded(from);
  while (taken.count(place) > 0)
    place[0] = std::nextafter(place[0], std::numeric_limits<float>::infinity());
  return place;
}

} // namespace

std::set<MeshEdge>
rimOf(const std::vector<Triangle>& triangles)
{
  std::set<MeshEdge> rim;
  for (const Triangle& triangle : triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const MeshEdge edge(triangle[i], triangle[(i + 1) % 3]);
      if (rim.erase({edge.second, edge.first}) == 0)
        rim.insert(edge);
    }
  return rim;
}

std::size_t
weldVertices(TriangleMesh& mesh)
{
  const std::vector<std::uint32_t> target = firstAtPosition(mesh.vertices);
  std::size_t welded = 0;
  for (std::uint32_t v = 0; v < target.size(); ++v)
    welded += target[v] != v;
  for (Triangle& triangle : mesh.triangles)
    for (auto& v : triangle)
      v = target[v];
  return welded;
}

std::size_t
partEqualPositions(TriangleMesh& mesh)
{
  std::set<Position> taken;
  for (Eigen::Vector3d& v : mesh.vertices) {
    const Position place = rounded(v);
    v = {place[0], place[1], place[2]};
    taken.insert(place);
  }
  const std::vector<std::uint32_t> first = firstAtPosition(mesh.vertices);
  std::vector<Eigen::Vector3d> sums(first.size(), Eigen::Vector3d::Zero());
  std::vector<double> counts(first.size(), 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (const auto v : mesh.triangles[t])
      if (first[v] != v) {
        sums[v] += (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3;
        ++counts[v];
      }
  std::size_t moved = 0;
  for (std::uint32_t v = 0; v < first.size(); ++v) {
    if (first[v] == v)
      continue;
    Eigen::Vector3d& vertex = mesh.vertices[v];
    const Eigen::Vector3d along = sums[v] / std::max(1., counts[v]) - vertex;
    const Position place = freePosition(vertex, along, taken);
    taken.insert(place);
    vertex = {place[0], place[1], place[2]};
    ++moved;
  }
  return moved;
}

RemovedComponents
keepLargestComponent(TriangleMesh& mesh)
{
  const auto component = labelComponents(mesh);
  std::vector<double> areas;
  for (std::size_t t = 0; t < component.size(); ++t) {
    if (component[t] == areas.size())
      areas.push_back(0);
    areas[component[t]] += mesh.scaledNormal(t).norm() / 2;
  }
  if (areas.size() <= 1)
    return {};
  const auto largest = std::max_element(areas.begin(), areas.end()) - areas.begin();
  std::vector<bool> keep(component.size());
  for (std::size_t t = 0; t < component.size(); ++t)
    keep[t] = component[t] == largest;
  return {areas.size() - 1, mesh.keepTriangles(keep)};
}

} // namespace pcl::sedr
