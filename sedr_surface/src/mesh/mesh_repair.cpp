// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_repair.h"

#include <pcl/sedr_surface/mesh_topology.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace pcl::sedr {
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
