// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_edges.h"

#include <pcl/sedr_surface/mesh_repair.h>

#include <array>
#include <limits>

namespace pcl {
namespace sedr {
namespace {

constexpr auto none = std::numeric_limits<std::uint32_t>::max();

// The neighbour across a side, where there is just one.
struct Neighbour {
  std::uint32_t triangle = none;
  bool agrees = true; ///< both have the same side up
};

std::vector<std::array<Neighbour, 3>>
collectNeighbours(const std::vector<Triangle>& triangles)
{
  std::vector<std::array<Neighbour, 3>> neighbours(triangles.size());
  forEachEdge(collectEdges(triangles), [&neighbours](auto first, auto last) {
    if (last - first != 2)
      return;
    const EdgeUse& a = *first;
    const EdgeUse& b = *(first + 1);
    const bool agrees = a.forward != b.forward;
    neighbours[a.triangle][a.side] = {b.triangle, agrees};
    neighbours[b.triangle][b.side] = {a.triangle, agrees};
  });
  return neighbours;
}

} // namespace

void
orientConsistently(TriangleMesh& mesh, MeshRepairReport& report)
{
  const auto neighbours = collectNeighbours(mesh.triangles);
  enum : std::uint8_t { Unknown, Keep, Turn };
  std::vector<std::uint8_t> state(mesh.triangles.size(), Unknown);
  std::vector<std::uint32_t> queue;
  std::size_t conflicts = 0; // each is seen from both sides
  for (std::uint32_t seed = 0; seed < mesh.triangles.size(); ++seed) {
    if (state[seed] != Unknown)
      continue;
    state[seed] = Keep;
    queue.assign(1, seed);
    for (std::size_t i = 0; i < queue.size(); ++i) {
      const std::uint8_t own = state[queue[i]];
      for (const Neighbour& n : neighbours[queue[i]]) {
        if (n.triangle == none)
          continue;
        const std::uint8_t wanted = n.agrees == (own == Keep) ? Keep : Turn;
        if (state[n.triangle] == Unknown) {
          state[n.triangle] = wanted;
          queue.push_back(n.triangle);
        }
        else if (state[n.triangle] != wanted)
          ++conflicts;
      }
    }
  }
  report.orientation_conflicts = conflicts / 2;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (state[t] == Turn) {
      std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
      ++report.flipped_triangles;
    }
}

std::size_t
orientNormals(TriangleMesh& mesh, NormalSide side)
{
  const auto component = labelComponents(mesh);
  std::vector<double> volumes;
  std::vector<Eigen::Vector3d> origins;
  for (std::size_t t = 0; t < component.size(); ++t) {
    if (component[t] >= volumes.size()) {
      volumes.push_back(0);
      origins.push_back(mesh.corner(t, 0));
    }
    volumes[component[t]] +=
        (mesh.corner(t, 0) - origins[component[t]]).dot(mesh.scaledNormal(t)) / 6;
  }
  const auto isWrong = [&volumes, side](std::uint32_t c) {
    return side == NormalSide::Outward ? volumes[c] < 0 : volumes[c] > 0;
  };
  for (std::size_t t = 0; t < component.size(); ++t)
    if (isWrong(component[t]))
      std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
  std::size_t turned = 0;
  for (std::uint32_t c = 0; c < volumes.size(); ++c)
    turned += isWrong(c);
  return turned;
}

} // namespace sedr
} // namespace pcl
