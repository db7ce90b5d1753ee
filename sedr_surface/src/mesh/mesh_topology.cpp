// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_edges.h"

#include "sedr_filters/src/grids/disjoint_sets.h"
#include <pcl/sedr_surface/mesh_topology.h>

#include <algorithm>

namespace pcl::sedr {
namespace {

bool
usesVertexTwice(const Triangle& t)
{
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

void
countVertices(const TriangleMesh& mesh, MeshTopology& topology)
{
  std::vector<bool> used(mesh.vertices.size(), false);
  for (const Triangle& triangle : mesh.triangles)
    for (const auto v : triangle)
      used[v] = true;
  topology.vertices =
      static_cast<std::size_t>(std::count(used.begin(), used.end(), true));
}

void
countTriangles(const TriangleMesh& mesh, MeshTopology& topology)
{
  topology.triangles = mesh.triangles.size();
  std::vector<Triangle> sorted;
  sorted.reserve(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (usesVertexTwice(mesh.triangles[t])) {
      ++topology.degenerate_triangles;
      continue;
    }
    if (mesh.scaledNormal(t).squaredNorm() == 0)
      ++topology.zero_area_triangles;
    sorted.push_back(mesh.triangles[t]);
    std::sort(sorted.back().begin(), sorted.back().end());
  }
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 1; i < sorted.size(); ++i)
    if (sorted[i] == sorted[i - 1])
      ++topology.duplicate_triangles;
}

void
countEdges(const std::vector<EdgeUse>& uses, MeshTopology& topology)
{
  forEachEdge(uses, [&topology](auto first, auto last) {
    ++topology.edges;
    const auto count = last - first;
    if (count == 1)
      ++topology.boundary_edges;
    else if (count > 2)
      ++topology.non_manifold_edges;
    else if (first->forward == (first + 1)->forward)
      ++topology.inconsistent_edges;
  });
}

// Counts fans: sets of corners at a vertex that are joined across edges.
void
countFans(const TriangleMesh& mesh,
          const std::vector<EdgeUse>& uses,
          MeshTopology& topology)
{
  DisjointSets<> corners(3 * mesh.triangles.size());
  forEachEdge(uses, [&corners](auto first, auto last) {
    for (auto use = first + 1; use != last; ++use) {
      corners.join(lowCorner(*first), lowCorner(*use));
      corners.join(highCorner(*first), highCorner(*use));
    }
  });
  std::vector<std::uint32_t> fans(mesh.vertices.size(), 0);
  for (std::uint32_t c = 0; c < 3 * mesh.triangles.size(); ++c)
    if (corners.find(c) == c && ++fans[mesh.triangles[c / 3][c % 3]] == 2)
      ++topology.non_manifold_vertices;
}

std::vector<std::uint32_t>
labelComponents(const TriangleMesh& mesh,
                const std::vector<EdgeUse>& uses,
                std::uint32_t& count)
{
  DisjointSets<> sets(mesh.triangles.size());
  forEachEdge(uses, [&sets](auto first, auto last) {
    for (auto use = first + 1; use != last; ++use)
      sets.join(first->triangle, use->triangle);
  });
  std::vector<std::uint32_t> component(mesh.triangles.size());
  count = 0;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::uint32_t root = sets.find(t); // the lowest, so it already has its number
    component[t] = root == t ? count++ : component[root];
  }
  return component;
}

void
measureComponents(const TriangleMesh& mesh,
                  const std::vector<EdgeUse>& uses,
                  MeshTopology& topology)
{
  std::uint32_t count = 0;
  const auto component = labelComponents(mesh, uses, count);
  topology.components.assign(count, {});
  std::vector<Eigen::Vector3d> origins(count);
  for (auto& c : topology.components)
    c.closed = true;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    MeshComponent& c = topology.components[component[t]];
    if (c.triangles++ == 0)
      origins[component[t]] = mesh.corner(t, 0);
    const Eigen::Vector3d& origin = origins[component[t]];
    const Eigen::Vector3d normal = mesh.scaledNormal(t);
    c.area += normal.norm() / 2;
    c.signed_volume += (mesh.corner(t, 0) - origin).dot(normal) / 6;
  }
  forEachEdge(uses, [&](auto first, auto last) {
    if (last - first == 1)
      topology.components[component[first->triangle]].closed = false;
  });
}

/** @brief Computes the connectivity of a mesh or of a part of one. */
MeshTopology
topologyOf(const TriangleMesh& mesh)
{
  MeshTopology topology;
  countVertices(mesh, topology);
  countTriangles(mesh, topology);
  const std::vector<EdgeUse> uses = collectEdges(mesh.triangles);
  countEdges(uses, topology);
  countFans(mesh, uses, topology);
  measureComponents(mesh, uses, topology);
  return topology;
}

/** @brief Triangles [first, last) with vertices [low, high] that no other part uses. */
struct MeshPart {
  std::size_t first;
  std::size_t last;
  std::uint32_t low;
  std::uint32_t high;
};

/** @brief Returns the rooms of a mesh if they are contiguous, else all of it. Room by
 * room, connectivity takes much less memory. */
std::vector<MeshPart>
partsByRoom(const TriangleMesh& mesh)
{
  std::vector<MeshPart> runs;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto [low, high] =
        std::minmax_element(mesh.triangles[t].begin(), mesh.triangles[t].end());
    if (t == 0 || (!mesh.rooms.empty() && mesh.rooms[t] != mesh.rooms[t - 1]))
      runs.push_back({t, t, *low, *high});
    MeshPart& run = runs.back();
    run = {run.first, t + 1, std::min(run.low, *low), std::max(run.high, *high)};
  }
  std::vector<MeshPart> parts;
  for (const MeshPart& run : runs) {
    parts.push_back(run);
    while (parts.size() > 1 && parts.back().low <= parts[parts.size() - 2].high) {
      MeshPart& before = parts[parts.size() - 2];
      before = {before.first, run.last, std::min(before.low, parts.back().low),
                std::max(before.high, parts.back().high)};
      parts.pop_back();
    }
  }
  return parts;
}

TriangleMesh
copyOf(const TriangleMesh& mesh, const MeshPart& part)
{
  TriangleMesh copy;
  copy.vertices.assign(mesh.vertices.begin() + part.low,
                       mesh.vertices.begin() + part.high + 1);
  for (std::size_t t = part.first; t < part.last; ++t) {
    copy.triangles.push_back(mesh.triangles[t]);
    for (auto& v : copy.triangles.back())
      v -= part.low;
  }
  return copy;
}

void
add(const MeshTopology& part, MeshTopology& sum)
{
  for (const auto count :
       {&MeshTopology::vertices, &MeshTopology::edges, &MeshTopology::triangles,
        &MeshTopology::degenerate_triangles, &MeshTopology::zero_area_triangles,
        &MeshTopology::duplicate_triangles, &MeshTopology::boundary_edges,
        &MeshTopology::non_manifold_edges, &MeshTopology::inconsistent_edges,
        &MeshTopology::non_manifold_vertices})
    sum.*count += part.*count;
  sum.components.insert(sum.components.end(), part.components.begin(),
                        part.components.end());
}

} // namespace

std::string
MeshTopology::problem() const
{
  if (triangles == 0)
    return "no triangles";
  const std::pair<std::size_t, const char*> counts[] = {
      {boundary_edges, "boundary edge"},
      {non_manifold_edges, "non-manifold edge"},
      {inconsistent_edges, "inconsistently oriented edge"},
      {degenerate_triangles, "degenerate triangle"},
      {duplicate_triangles, "duplicate triangle"}};
  std::string text;
  const auto add = [&text](std::size_t count, const std::string& name) {
    if (count > 0)
      text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + name;
  };
  for (const auto& count : counts)
    add(count.first, count.second + std::string(count.first == 1 ? "" : "s"));
  add(non_manifold_vertices,
      non_manifold_vertices == 1 ? "non-manifold vertex" : "non-manifold vertices");
  return text;
}

MeshTopology
checkTopology(const TriangleMesh& mesh)
{
  const std::vector<MeshPart> parts = partsByRoom(mesh);
  MeshTopology topology;
  if (parts.size() == 1)
    topology = topologyOf(mesh);
  else
    for (const MeshPart& part : parts)
      add(topologyOf(copyOf(mesh, part)), topology);
  topology.unused_vertices = mesh.vertices.size() - topology.vertices;
  topology.euler_characteristic = static_cast<std::int64_t>(topology.vertices) -
                                  static_cast<std::int64_t>(topology.edges) +
                                  static_cast<std::int64_t>(topology.triangles);
  std::stable_sort(topology.components.begin(), topology.components.end(),
                   [](const auto& a, const auto& b) { return a.area > b.area; });
  return topology;
}

std::vector<std::uint32_t>
labelComponents(const TriangleMesh& mesh)
{
  std::uint32_t count = 0;
  return labelComponents(mesh, collectEdges(mesh.triangles), count);
}

} // namespace pcl::sedr
