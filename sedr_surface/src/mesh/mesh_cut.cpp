// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_edges.h"

#include "sedr_filters/src/grids/disjoint_sets.h"
#include <pcl/sedr_surface/mesh_repair.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace pcl {
namespace sedr {
namespace {

constexpr auto none = std::numeric_limits<std::uint32_t>::max();
constexpr double pull = 0.02; // share of the way to the middle of the own triangles

// One or two sides that belong together at an edge that several sheets share.
struct Sheet {
  std::array<EdgeUse, 2> sides;
  int count = 0;
};

// A side with the direction in which its triangle leaves the edge.
struct Leaf {
  EdgeUse use;
  double angle = 0;
};

std::vector<Leaf>
sortByAngle(const TriangleMesh& mesh, const EdgeUse* first, const EdgeUse* last)
{
  const Eigen::Vector3d& low = mesh.vertices[first->low];
  const Eigen::Vector3d axis = (mesh.vertices[first->high] - low).normalized();
  const Eigen::Vector3d u = axis.unitOrthogonal();
  const Eigen::Vector3d v = axis.cross(u);
  std::vector<Leaf> leaves;
  for (auto use = first; use != last; ++use) {
    const Eigen::Vector3d w = mesh.corner(use->triangle, (use->side + 2) % 3) - low;
    leaves.push_back({*use, std::atan2(w.dot(v), w.dot(u))});
  }
  std::stable_sort(leaves.begin(), leaves.end(),
                   [](const Leaf& a, const Leaf& b) { return a.angle < b.angle; });
  return leaves;
}

// Takes neighbours i and i + 1 of the ring out as a sheet.
Sheet
takePair(std::vector<Leaf>& ring, std::size_t i)
{
  const std::size_t j = (i + 1) % ring.size();
  const Sheet sheet{{ring[i].use, ring[j].use}, 2};
  ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(std::max(i, j)));
  ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(std::min(i, j)));
  return sheet;
}

// With the angle, the normal of a side that runs forward points on, that of one that
// runs backward points back: forward, then backward encloses the space in front of
// both.
std::vector<Sheet>
pairSides(const TriangleMesh& mesh,
          const EdgeUse* first,
          const EdgeUse* last,
          KeepApart apart)
{
  std::vector<Leaf> ring = sortByAngle(mesh, first, last);
  std::vector<Sheet> sheets;
  const bool leading = apart == KeepApart::InFront;
  for (bool found = true; found && ring.size() > 1;) {
    found = false;
    for (std::size_t i = 0; i < ring.size() && !found; ++i) {
      const EdgeUse& next = ring[(i + 1) % ring.size()].use;
      if (ring[i].use.forward == leading && next.forward != leading) {
        sheets.push_back(takePair(ring, i));
        found = true;
      }
    }
  }
  while (ring.size() > 1) // all alike: not consistently oriented here
    sheets.push_back(takePair(ring, 0));
  if (!ring.empty())
    sheets.push_back({{ring[0].use, {}}, 1});
  return sheets;
}

void
joinSides(const EdgeUse& a, const EdgeUse& b, DisjointSets<>& corners)
{
  corners.join(lowCorner(a), lowCorner(b));
  corners.join(highCorner(a), highCorner(b));
}

// Gives every fan a vertex of its own; the first fan of a vertex keeps it.
// Returns which vertices had more than one fan, and their copies.
std::vector<bool>
separateFans(TriangleMesh& mesh, DisjointSets<>& corners, MeshRepairReport& report)
{
  const auto corner_count = static_cast<std::uint32_t>(3 * mesh.triangles.size());
  std::vector<std::uint32_t> own_vertex(corner_count, none); // of the root of a fan
  std::vector<bool> taken(mesh.vertices.size(), false);
  std::vector<bool> moves(mesh.vertices.size(), false);
  for (std::uint32_t c = 0; c < corner_count; ++c) {
    if (corners.find(c) != c)
      continue;
    const std::uint32_t vertex = mesh.triangles[c / 3][c % 3];
    own_vertex[c] = vertex;
    if (!taken[vertex]) {
      taken[vertex] = true;
      continue;
    }
    report.cut_vertices += moves[vertex] ? 0 : 1;
    moves[vertex] = true;
    own_vertex[c] = static_cast<std::uint32_t>(mesh.vertices.size());
    const Eigen::Vector3d position = mesh.vertices[vertex];
    mesh.vertices.push_back(position);
    moves.push_back(true);
  }
  for (std::uint32_t c = 0; c < corner_count; ++c)
    mesh.triangles[c / 3][c % 3] = own_vertex[corners.find(c)];
  return moves;
}

void
pullApart(TriangleMesh& mesh, const std::vector<bool>& moves)
{
  std::vector<Eigen::Vector3d> sum(mesh.vertices.size(), Eigen::Vector3d::Zero());
  std::vector<int> count(mesh.vertices.size(), 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (const auto v : mesh.triangles[t])
      if (moves[v]) {
        sum[v] += (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3;
        ++count[v];
      }
  for (std::size_t v = 0; v < moves.size(); ++v)
    if (moves[v] && count[v] > 0)
      mesh.vertices[v] += pull * (sum[v] / count[v] - mesh.vertices[v]);
}

using Middles = std::map<std::uint32_t, std::array<std::uint32_t, 3>>;

// A vertex in the middle of the sheet's edge, for the sheet alone.
void
addMiddle(TriangleMesh& mesh, const Sheet& sheet, Middles& middles)
{
  const Triangle& triangle = mesh.triangles[sheet.sides[0].triangle];
  const Eigen::Vector3d edge =
      (mesh.vertices[triangle[sheet.sides[0].side]] +
       mesh.vertices[triangle[(sheet.sides[0].side + 1u) % 3u]]) /
      2;
  Eigen::Vector3d away = Eigen::Vector3d::Zero();
  for (int i = 0; i < sheet.count; ++i) {
    const EdgeUse& use = sheet.sides[static_cast<std::size_t>(i)];
    away += (mesh.corner(use.triangle, (use.side + 2) % 3) - edge) / sheet.count;
    auto& sides =
        middles.try_emplace(use.triangle, Triangle{none, none, none}).first->second;
    sides[use.side] = static_cast<std::uint32_t>(mesh.vertices.size());
  }
  mesh.vertices.push_back(edge + pull * away);
}

// Replaces triangle `t` by triangles that run through the middles of its sides.
void
splitTriangle(TriangleMesh& mesh,
              std::uint32_t t,
              const std::array<std::uint32_t, 3>& middle)
{
  const Triangle old = mesh.triangles[t];
  const auto add = [&mesh, t](const Triangle& triangle) {
    mesh.triangles.push_back(triangle);
    for (auto* attribute : mesh.attributes())
      if (!attribute->empty())
        attribute->push_back((*attribute)[t]);
  };
  const auto count = 3 - std::count(middle.begin(), middle.end(), none);
  if (count == 3) {
    for (std::size_t i = 0; i < 3; ++i)
      add({middle[i], old[(i + 1) % 3], middle[(i + 1) % 3]});
    mesh.triangles[t] = {middle[0], middle[1], middle[2]};
    return;
  }
  std::size_t s =
      0; // the first side with a middle; of two, the one that the other follows
  while (middle[s] == none || (count == 2 && middle[(s + 1) % 3] == none))
    ++s;
  const std::uint32_t a = old[s];
  const std::uint32_t b = old[(s + 1) % 3];
  const std::uint32_t c = old[(s + 2) % 3];
  mesh.triangles[t] = {middle[s], c, a};
  if (count == 1) {
    add({middle[s], b, c});
    return;
  }
  const std::uint32_t second = middle[(s + 1) % 3];
  add({middle[s], b, second});
  add({middle[s], second, c});
}

// Sheets that still share both ends of an edge get a middle, all but the first.
void
separateDoubledEdges(TriangleMesh& mesh,
                     const std::vector<Sheet>& sheets,
                     MeshRepairReport& report)
{
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> seen;
  Middles middles;
  for (const Sheet& sheet : sheets) {
    const Triangle& triangle = mesh.triangles[sheet.sides[0].triangle];
    const std::uint32_t from = triangle[sheet.sides[0].side];
    const std::uint32_t to = triangle[(sheet.sides[0].side + 1u) % 3u];
    if (seen[{std::min(from, to), std::max(from, to)}]++ == 0)
      continue;
    addMiddle(mesh, sheet, middles);
    ++report.split_edges;
  }
  for (const auto& triangle : middles)
    splitTriangle(mesh, triangle.first, triangle.second);
}

} // namespace

void
cutNonManifold(TriangleMesh& mesh, KeepApart apart, MeshRepairReport& report)
{
  DisjointSets<> corners(3 * mesh.triangles.size());
  std::vector<Sheet> sheets;
  forEachEdge(collectEdges(mesh.triangles), [&](auto first, auto last) {
    if (last - first == 2)
      joinSides(*first, *(first + 1), corners);
    if (last - first <= 2)
      return;
    ++report.cut_edges;
    for (const Sheet& sheet :
         pairSides(mesh, &*first, &*first + (last - first), apart)) {
      if (sheet.count == 2)
        joinSides(sheet.sides[0], sheet.sides[1], corners);
      sheets.push_back(sheet);
    }
  });
  const std::vector<bool> moves = separateFans(mesh, corners, report);
  pullApart(mesh, moves);
  separateDoubledEdges(mesh, sheets, report);
}

} // namespace sedr
} // namespace pcl
