// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_repair.h"

#include <pcl/sedr_surface/mesh_topology.h>

#include <algorithm>
#include <numeric>
#include <tuple>
#include <vector>

namespace pcl::sedr {

std::size_t
weldVertices(TriangleMesh& mesh)
{
  const std::vector<Eigen::Vector3d>& vertices = mesh.vertices;
  std::vector<std::uint32_t> order(vertices.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto key = [&vertices](std::uint32_t v) {
    return std::make_tuple(vertices[v].x(), vertices[v].y(), vertices[v].z());
  };
  std::sort(order.begin(), order.end(), [&key](std::uint32_t a, std::uint32_t b) {
    return key(a) != key(b) ? key(a) < key(b) : a < b;
  });
  std::vector<std::uint32_t> target(vertices.size()); // lowest one per position
  std::size_t welded = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool is_equal = i > 0 && key(order[i]) == key(order[i - 1]);
    target[order[i]] = is_equal ? target[order[i - 1]] : order[i];
    welded += is_equal ? 1 : 0;
  }
  for (Triangle& triangle : mesh.triangles)
    for (auto& v : triangle)
      v = target[v];
  return welded;
}

RemovedComponents
keepLargestComponent(TriangleMesh& mesh)
{
  const auto component = labelComponents(mesh);
  std::vector<double> areas;
  for (std::size_t t = 0; t < component.size(); ++t) {
    if (component[t] >= areas.size())
      areas.resize(component[t] + 1u, 0.);
    areas[component[t]] += mesh.scaledNormal(t).norm() / 2;
  }
  if (areas.size() <= 1)
    return {};
  const auto largest = static_cast<std::size_t>(
      std::max_element(areas.begin(), areas.end()) - areas.begin());
  std::vector<bool> keep(component.size());
  for (std::size_t t = 0; t < component.size(); ++t)
    keep[t] = component[t] == largest;
  return {areas.size() - 1, mesh.keepTriangles(keep)};
}

} // namespace pcl::sedr
