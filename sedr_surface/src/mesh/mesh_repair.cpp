// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_edges.h"

#include <pcl/sedr_surface/mesh_repair.h>

#include <algorithm>
#include <limits>
#include <numeric>

namespace pcl {
namespace sedr {
namespace {

// Copies the attributes of triangle `like` for a triangle that is added behind the
// others.
void
addTriangleLike(TriangleMesh& mesh, const Triangle& triangle, std::uint32_t like)
{
  mesh.triangles.push_back(triangle);
  for (auto* attribute : mesh.attributes())
    if (!attribute->empty())
      attribute->push_back((*attribute)[like]);
}

constexpr auto none = std::numeric_limits<std::uint32_t>::max();

// A boundary edge as the hole sees it: against the sense of its triangle.
struct HoleEdge {
  std::uint32_t next = none; ///< vertex that the hole's outline goes on to
  std::uint32_t triangle = none;
  bool branches = false; ///< more than one outline leaves the vertex
};

std::vector<HoleEdge>
collectHoleEdges(const TriangleMesh& mesh)
{
  std::vector<HoleEdge> edges(mesh.vertices.size());
  forEachEdge(collectEdges(mesh.triangles), [&edges](auto first, auto last) {
    if (last - first != 1)
      return;
    HoleEdge& edge = edges[first->forward ? first->high : first->low];
    edge.branches = edge.next != none;
    edge.next = first->forward ? first->low : first->high;
    edge.triangle = first->triangle;
  });
  return edges;
}

// The outline that starts at `start`, or nothing if it does not come back there.
std::vector<std::uint32_t>
traceHole(const std::vector<HoleEdge>& edges,
          std::uint32_t start,
          std::vector<bool>& visited)
{
  std::vector<std::uint32_t> loop;
  bool simple = true;
  for (std::uint32_t v = start; v != none && !visited[v]; v = edges[v].next) {
    visited[v] = true;
    loop.push_back(v);
    simple = simple && !edges[v].branches;
  }
  if (!simple || loop.size() < 3 || edges[loop.back()].next != start)
    loop.clear();
  return loop;
}

void
fillLoop(TriangleMesh& mesh,
         const std::vector<HoleEdge>& edges,
         const std::vector<std::uint32_t>& loop)
{
  if (loop.size() == 3) {
    addTriangleLike(mesh, {loop[0], loop[1], loop[2]}, edges[loop[0]].triangle);
    return;
  }
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (const auto v : loop)
    centre += mesh.vertices[v] / static_cast<double>(loop.size());
  const auto hub = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.push_back(centre);
  for (const auto v : loop)
    addTriangleLike(mesh, {v, edges[v].next, hub}, edges[v].triangle);
}

} // namespace

MeshRepairReport&
MeshRepairReport::operator+=(const MeshRepairReport& other)
{
  welded_vertices += other.welded_vertices;
  dropped_triangles += other.dropped_triangles;
  cut_edges += other.cut_edges;
  cut_vertices += other.cut_vertices;
  split_edges += other.split_edges;
  flipped_triangles += other.flipped_triangles;
  orientation_conflicts += other.orientation_conflicts;
  filled_holes += other.filled_holes;
  filled_edges += other.filled_edges;
  open_holes += other.open_holes;
  collapsed_edges += other.collapsed_edges;
  parted_vertices += other.parted_vertices;
  removed_components += other.removed_components;
  removed_triangles += other.removed_triangles;
  return *this;
}

void
fillHoles(TriangleMesh& mesh, std::size_t max_edges, MeshRepairReport& report)
{
  const auto edges = collectHoleEdges(mesh);
  std::vector<bool> visited(edges.size(), false);
  report.open_holes = 0;
  for (std::uint32_t v = 0; v < edges.size(); ++v) {
    if (visited[v] || edges[v].next == none)
      continue;
    const auto loop = traceHole(edges, v, visited);
    // A lone triangle would only get its own back side.
    const bool alone = loop.size() == 3 &&
                       edges[loop[0]].triangle == edges[loop[1]].triangle &&
                       edges[loop[0]].triangle == edges[loop[2]].triangle;
    if (loop.empty() || loop.size() > max_edges || alone) {
      ++report.open_holes;
      continue;
    }
    fillLoop(mesh, edges, loop);
    ++report.filled_holes;
    report.filled_edges += loop.size();
  }
}

void
keepLargestComponents(TriangleMesh& mesh, std::size_t count, MeshRepairReport& report)
{
  const auto component = labelComponents(mesh);
  std::vector<double> areas;
  for (std::size_t t = 0; t < component.size(); ++t) {
    if (component[t] >= areas.size())
      areas.resize(component[t] + 1u, 0.);
    areas[component[t]] += mesh.scaledNormal(t).norm() / 2;
  }
  if (areas.size() <= count)
    return;
  std::vector<std::uint32_t> order(areas.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&areas](auto a, auto b) { return areas[a] > areas[b]; });
  std::vector<bool> kept(areas.size(), false);
  for (std::size_t i = 0; i < count; ++i)
    kept[order[i]] = true;
  std::vector<bool> keep(component.size());
  for (std::size_t t = 0; t < component.size(); ++t)
    keep[t] = kept[component[t]];
  report.removed_triangles += mesh.keepTriangles(keep);
  report.removed_components += areas.size() - count;
}

MeshTopology
repairMesh(TriangleMesh& mesh,
           const MeshRepairOptions& options,
           MeshRepairReport& report)
{
  report = MeshRepairReport();
  if (options.weld_tolerance >= 0)
    report.welded_vertices = weldVertices(mesh, options.weld_tolerance);
  MeshTopology topology;
  // Cutting can lay holes open and filling them can touch other sheets: a few rounds
  // settle it.
  for (int round = 0; round < 4; ++round) {
    report.dropped_triangles += dropDegenerateTriangles(mesh);
    orientConsistently(mesh, report);
    cutNonManifold(mesh, options.apart, report);
    orientConsistently(mesh, report);
    if (options.keep_components > 0)
      keepLargestComponents(mesh, options.keep_components, report);
    fillHoles(mesh, options.max_hole_edges, report);
    if (options.shortest_edge > 0)
      report.collapsed_edges += collapseShortEdges(mesh, options.shortest_edge);
    topology = checkTopology(mesh);
    if (topology.isClosedManifold())
      break;
  }
  orientNormals(mesh, options.normals);
  mesh.removeUnusedVertices();
  return checkTopology(mesh);
}

} // namespace sedr
} // namespace pcl
