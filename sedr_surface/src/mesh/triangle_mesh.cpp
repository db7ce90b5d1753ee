// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_surface/triangle_mesh.h>

#include "sedr_filters/src/grids/disjoint_sets.h"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

namespace pcl::sedr {
using Attribute = std::vector<std::uint32_t>;

double
TriangleMesh::area() const
{
  double twice = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    twice += scaledNormal(t).norm();
  return twice / 2;
}

double
TriangleMesh::signedVolume() const
{
  if (empty())
    return 0;
  // Relative to a vertex of the mesh, to keep precision at large coordinates.
  const Eigen::Vector3d origin = corner(0, 0);
  double six_fold = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    six_fold += (corner(t, 0) - origin)
                    .dot((corner(t, 1) - origin).cross(corner(t, 2) - origin));
  return six_fold / 6;
}

Eigen::AlignedBox3d
TriangleMesh::bounds() const
{
  Eigen::AlignedBox3d box;
  for (const Triangle& triangle : triangles)
    for (const auto v : triangle)
      box.extend(vertices[v]);
  return box;
}

void
TriangleMesh::flip()
{
  for (Triangle& triangle : triangles)
    std::swap(triangle[1], triangle[2]);
}

void
TriangleMesh::append(const TriangleMesh& other)
{
  const auto shift = static_cast<std::uint32_t>(vertices.size());
  const std::size_t before = triangles.size();
  const std::size_t added = other.triangles.size();
  for (Attribute TriangleMesh::*const of :
       {&TriangleMesh::labels, &TriangleMesh::rooms, &TriangleMesh::elements})
    if (!(this->*of).empty() || !(other.*of).empty()) {
      (this->*of).resize(before, 0);
      (this->*of).insert((this->*of).end(), (other.*of).begin(), (other.*of).end());
      (this->*of).resize(before + added, 0);
    }
  vertices.insert(vertices.end(), other.vertices.begin(), other.vertices.end());
  for (std::size_t t = 0; t < added; ++t) {
    const Triangle& triangle = other.triangles[t];
    triangles.push_back(
        {triangle[0] + shift, triangle[1] + shift, triangle[2] + shift});
  }
}

std::size_t
TriangleMesh::keepTriangles(const std::vector<bool>& keep)
{
  std::size_t kept = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (!keep[t])
      continue;
    triangles[kept] = triangles[t];
    for (Attribute* attribute : attributes())
      if (!attribute->empty())
        (*attribute)[kept] = (*attribute)[t];
    ++kept;
  }
  const std::size_t removed = triangles.size() - kept;
  triangles.resize(kept);
  for (Attribute* attribute : attributes())
    if (!attribute->empty())
      attribute->resize(kept);
  return removed;
}

std::size_t
TriangleMesh::removeUnusedVertices()
{
  constexpr auto unused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> new_index(vertices.size(), unused);
  for (const Triangle& triangle : triangles)
    for (const auto v : triangle)
      new_index[v] = 0;
  std::uint32_t kept = 0;
  for (std::size_t v = 0; v < vertices.size(); ++v)
    if (new_index[v] != unused) {
      vertices[kept] = vertices[v];
      new_index[v] = kept++;
    }
  const std::size_t removed = vertices.size() - kept;
  vertices.resize(kept);
  for (Triangle& triangle : triangles)
    for (auto& v : triangle)
      v = new_index[v];
  return removed;
}

std::string
TriangleMesh::problem() const
{
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (const auto v : triangles[t])
      if (v >= vertices.size())
        return "triangle " + std::to_string(t) + " uses vertex " + std::to_string(v) +
               ", the mesh has " + std::to_string(vertices.size()) + " vertices";
  for (std::size_t v = 0; v < vertices.size(); ++v)
    if (!vertices[v].allFinite())
      return "vertex " + std::to_string(v) + " is not finite";
  const auto isOfAnotherLength = [this](const Attribute& attribute) {
    return !attribute.empty() && attribute.size() != triangles.size();
  };
  if (isOfAnotherLength(labels) || isOfAnotherLength(rooms) ||
      isOfAnotherLength(elements))
    return "the mesh has " + std::to_string(triangles.size()) + " triangles, but " +
           std::to_string(labels.size()) + " labels, " + std::to_string(rooms.size()) +
           " rooms and " + std::to_string(elements.size()) + " elements";
  return {};
}

namespace {

/** @brief One side of a triangle, indexed by its edge. */
struct EdgeUse {
  std::uint32_t low = 0;      ///< vertex of the edge with the lower index
  std::uint32_t high = 0;     ///< the other one
  std::uint32_t triangle = 0; ///< the triangle
  std::uint8_t side = 0;      ///< from corner `side` to the next
  bool forward = false;       ///< the triangle runs from low to high

  /** @brief Returns the corner of the triangle at the lower vertex of the edge, or at
   * the higher one: 3 * triangle + corner. */
  std::uint32_t corner(bool is_low) const
  {
    return 3 * triangle + (forward == is_low ? side : (side + 1u) % 3u);
  }
};

/** @brief Calls `visit(first, last)` with the sides of triangles at every edge, in
 * order, which are sorted by triangle. Sides between a vertex and itself are omitted.
 * O(n log n). */
template <typename Visit>
void
forEachEdge(const std::vector<Triangle>& triangles, Visit visit)
{
  std::vector<EdgeUse> uses;
  uses.reserve(3 * triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (std::uint8_t side = 0; side < 3; ++side) {
      const std::uint32_t from = triangles[t][side];
      const std::uint32_t to = triangles[t][(side + 1u) % 3u];
      if (from != to)
        uses.push_back({std::min(from, to), std::max(from, to), t, side, from < to});
    }
  std::sort(uses.begin(), uses.end(), [](const EdgeUse& a, const EdgeUse& b) {
    return std::tie(a.low, a.high, a.triangle, a.side) <
           std::tie(b.low, b.high, b.triangle, b.side);
  });
  for (auto first = uses.begin(); first != uses.end();) {
    auto last = first + 1;
    while (last != uses.end() && last->low == first->low && last->high == first->high)
      ++last;
    visit(first, last);
    first = last;
  }
}

/** @brief Numbers the sets of triangles in the order of their first ones. */
std::vector<std::uint32_t>
numbered(DisjointSets<>& sets, std::size_t triangles)
{
  std::vector<std::uint32_t> component(triangles);
  std::uint32_t count = 0;
  for (std::uint32_t t = 0; t < triangles; ++t) {
    const std::uint32_t root = sets.find(t); // the lowest, so it already has its number
    component[t] = root == t ? count++ : component[root];
  }
  return component;
}

void
countTriangles(const TriangleMesh& mesh, MeshTopology& topology)
{
  topology.triangles = mesh.triangles.size();
  std::vector<Triangle> sorted;
  sorted.reserve(mesh.triangles.size());
  for (Triangle triangle : mesh.triangles) {
    std::sort(triangle.begin(), triangle.end());
    if (std::adjacent_find(triangle.begin(), triangle.end()) != triangle.end())
      ++topology.degenerate_triangles;
    else
      sorted.push_back(triangle);
  }
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 1; i < sorted.size(); ++i)
    if (sorted[i] == sorted[i - 1])
      ++topology.duplicate_triangles;
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
  MeshTopology topology;
  countTriangles(mesh, topology);
  const std::size_t n = mesh.triangles.size();
  DisjointSets<> corners(3 * n); // at a vertex those of a fan are joined across edges
  DisjointSets<> triangles(n);
  std::vector<std::uint32_t> at_rim;
  forEachEdge(mesh.triangles, [&](auto first, auto last) {
    ++topology.edges;
    if (last - first == 1)
      at_rim.push_back(first->triangle);
    else if (last - first > 2)
      ++topology.non_manifold_edges;
    else if (first->forward == (first + 1)->forward)
      ++topology.inconsistent_edges;
    for (auto use = first + 1; use != last; ++use) {
      corners.join(first->corner(true), use->corner(true));
      corners.join(first->corner(false), use->corner(false));
      triangles.join(first->triangle, use->triangle);
    }
  });
  topology.boundary_edges = at_rim.size();
  std::vector<std::uint32_t> fans(mesh.vertices.size(), 0);
  for (std::uint32_t c = 0; c < 3 * n; ++c)
    if (corners.find(c) == c)
      ++fans[mesh.triangles[c / 3][c % 3]];
  for (const std::uint32_t count : fans) {
    topology.vertices += count > 0 ? 1 : 0;
    topology.non_manifold_vertices += count > 1 ? 1 : 0;
  }
  topology.euler_characteristic = static_cast<std::int64_t>(topology.vertices) -
                                  static_cast<std::int64_t>(topology.edges) +
                                  static_cast<std::int64_t>(topology.triangles);
  const std::vector<std::uint32_t> component = numbered(triangles, n);
  std::vector<Eigen::Vector3d> origins; // of the components
  for (std::size_t t = 0; t < n; ++t) {
    if (component[t] == origins.size()) {
      origins.push_back(mesh.corner(t, 0));
      topology.components.push_back({0, 0, 0, true});
    }
    MeshComponent& c = topology.components[component[t]];
    const Eigen::Vector3d normal = mesh.scaledNormal(t);
    ++c.triangles;
    c.area += normal.norm() / 2;
    c.signed_volume += (mesh.corner(t, 0) - origins[component[t]]).dot(normal) / 6;
  }
  for (const std::uint32_t t : at_rim)
    topology.components[component[t]].closed = false;
  std::stable_sort(topology.components.begin(), topology.components.end(),
                   [](const auto& a, const auto& b) { return a.area > b.area; });
  return topology;
}

std::vector<std::uint32_t>
labelComponents(const TriangleMesh& mesh)
{
  DisjointSets<> triangles(mesh.triangles.size());
  forEachEdge(mesh.triangles, [&](auto first, auto last) {
    for (auto use = first + 1; use != last; ++use)
      triangles.join(first->triangle, use->triangle);
  });
  return numbered(triangles, mesh.triangles.size());
}

} // namespace pcl::sedr
