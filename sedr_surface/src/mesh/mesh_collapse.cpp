// SPDX-License-Identifier: BSD-3-Clause
#include "../isosurface/edge_link.h"
#include "mesh_edges.h"

#include <pcl/sedr_surface/mesh_repair.h>

#include <algorithm>

namespace pcl {
namespace sedr {
namespace {

// The mesh while edges collapse: which triangles live, and which meet at each vertex.
class Collapser {
public:
  explicit Collapser(TriangleMesh& mesh)
      : mesh_(mesh)
      , alive_(mesh.triangles.size(), true)
      , around_(mesh.vertices.size())
  {
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
      for (const auto v : mesh.triangles[t])
        around_[v].push_back(t);
  }

  // Collapses the edge from a to b if it is there, shorter than `length`, inside a
  // manifold surface, and no triangle about it would turn over.
  bool tryCollapse(std::uint32_t a, std::uint32_t b, double length)
  {
    if ((mesh_.vertices[a] - mesh_.vertices[b]).norm() >= length)
      return false;
    std::vector<std::uint32_t> shared;
    for (const auto t : around_[a])
      if (uses(t, b))
        shared.push_back(t);
    if (shared.size() != 2 || !keepsTopology(a, b))
      return false;
    const Eigen::Vector3d middle = (mesh_.vertices[a] + mesh_.vertices[b]) / 2;
    if (turnsOver(a, b, middle) || turnsOver(b, a, middle))
      return false;
    collapse(a, b, middle, shared);
    return true;
  }

  const std::vector<bool>& alive() const { return alive_; }

private:
  bool uses(std::uint32_t t, std::uint32_t v) const
  {
    const Triangle& triangle = mesh_.triangles[t];
    return triangle[0] == v || triangle[1] == v || triangle[2] == v;
  }

  bool keepsTopology(std::uint32_t a, std::uint32_t b) const
  {
    const EdgeLink link = linkOf(mesh_, a, around_[a], b, around_[b]);
    return link.common.size() == 2 && around_[link.common[0]].size() > 3 &&
           around_[link.common[1]].size() > 3 && link.of_a == around_[a].size() &&
           link.of_b == around_[b].size();
  }

  // A triangle at `v` that does not use `other` would face the other way with `v` at
  // `target`.
  bool
  turnsOver(std::uint32_t v, std::uint32_t other, const Eigen::Vector3d& target) const
  {
    for (const auto t : around_[v]) {
      if (uses(t, other))
        continue;
      Eigen::Vector3d p[3];
      for (int i = 0; i < 3; ++i)
        p[i] = mesh_.triangles[t][static_cast<std::size_t>(i)] == v
                   ? target
                   : mesh_.corner(t, i);
      const Eigen::Vector3d before = mesh_.scaledNormal(t);
      const Eigen::Vector3d after = (p[1] - p[0]).cross(p[2] - p[0]);
      if (before.dot(after) < 0.2 * before.norm() * after.norm() ||
          (after.isZero(0) && !before.isZero(0)))
        return true;
    }
    return false;
  }

  void collapse(std::uint32_t a,
                std::uint32_t b,
                const Eigen::Vector3d& middle,
                const std::vector<std::uint32_t>& shared)
  {
    for (const auto t : shared) {
      alive_[t] = false;
      for (const auto v : mesh_.triangles[t]) {
        auto& list = around_[v];
        list.erase(std::remove(list.begin(), list.end(), t), list.end());
      }
    }
    mesh_.vertices[a] = middle;
    for (const auto t : around_[b]) {
      for (auto& v : mesh_.triangles[t])
        if (v == b)
          v = a;
      around_[a].push_back(t);
    }
    around_[b].clear();
  }

  TriangleMesh& mesh_;
  std::vector<bool> alive_;
  std::vector<std::vector<std::uint32_t>> around_;
};

struct ShortEdge {
  double length;
  std::uint32_t low;
  std::uint32_t high;
};

// Edges below the length, the shortest first.
std::vector<ShortEdge>
collectShortEdges(const TriangleMesh& mesh, double length)
{
  std::vector<ShortEdge> edges;
  for (const Triangle& triangle : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = triangle[i];
      const std::uint32_t to = triangle[(i + 1) % 3];
      const double d = (mesh.vertices[from] - mesh.vertices[to]).norm();
      if (from < to && d < length)
        edges.push_back({d, from, to});
    }
  std::sort(edges.begin(), edges.end(), [](const ShortEdge& a, const ShortEdge& b) {
    return std::tie(a.length, a.low, a.high) < std::tie(b.length, b.low, b.high);
  });
  return edges;
}

} // namespace

std::size_t
collapseShortEdges(TriangleMesh& mesh, double length)
{
  std::size_t collapsed = 0;
  for (int round = 0; round < 3; ++round) {
    const auto edges = collectShortEdges(mesh, length);
    if (edges.empty())
      break;
    Collapser collapser(mesh);
    std::size_t in_round = 0;
    for (const ShortEdge& edge : edges)
      in_round += collapser.tryCollapse(edge.low, edge.high, length);
    mesh.keepTriangles(collapser.alive());
    collapsed += in_round;
    if (in_round == 0)
      break;
  }
  return collapsed;
}

} // namespace sedr
} // namespace pcl
