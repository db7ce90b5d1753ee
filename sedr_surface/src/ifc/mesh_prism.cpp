// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_prism.h"

#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace pcl::sedr::ifc {

TriangleMesh
prismOn(const TriangleMesh& mesh,
        const std::vector<std::size_t>& triangles,
        const std::function<double(const Eigen::Vector3d&)>& height_at)
{
  TriangleMesh prism;
  std::map<std::uint32_t, std::uint32_t> taken;
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const std::size_t t : triangles) {
    Triangle own;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = mesh.triangles[t][k];
      const auto [at, is_new] =
          taken.emplace(v, static_cast<std::uint32_t>(prism.vertices.size()));
      if (is_new)
        prism.vertices.push_back(mesh.vertices[v]);
      own[k] = at->second;
    }
    prism.triangles.push_back(own);
    for (std::size_t k = 0; k < 3; ++k)
      edges.emplace(own[k], own[(k + 1) % 3]);
  }
  const auto n = static_cast<std::uint32_t>(prism.vertices.size());
  for (std::uint32_t v = 0; v < n; ++v) {
    const Eigen::Vector3d p = prism.vertices[v];
    prism.vertices.emplace_back(p.x(), p.y(), height_at(p));
  }
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const Triangle own = prism.triangles[t];
    prism.triangles.push_back({own[0] + n, own[2] + n, own[1] + n});
  }
  for (const auto& [a, b] : edges)
    if (edges.count({b, a}) == 0) { // the rim
      prism.triangles.push_back({b, a, a + n});
      prism.triangles.push_back({b, a + n, b + n});
    }
  if (prism.signedVolume() < 0)
    prism.flip();
  return prism;
}

std::vector<std::size_t>
allTriangles(const TriangleMesh& mesh)
{
  std::vector<std::size_t> all(mesh.triangles.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

TriangleMesh
lowered(TriangleMesh mesh, double height)
{
  for (Eigen::Vector3d& vertex : mesh.vertices)
    vertex.z() -= height;
  return mesh;
}

} // namespace pcl::sedr::ifc
