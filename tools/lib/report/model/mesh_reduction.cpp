// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_reduction.h"

#include <cmath>
#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

namespace pcl::sedr::tools {

namespace {

/** @brief Returns how sharply the surface bends at each vertex: 0 if flat, up to 1. */
std::vector<double>
sharpness(const TriangleMesh& mesh)
{
  std::vector<Eigen::Vector3d> sums(mesh.vertices.size(), Eigen::Vector3d::Zero());
  std::vector<double> areas(mesh.vertices.size(), 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Eigen::Vector3d normal = mesh.scaledNormal(t);
    for (const auto v : mesh.triangles[t]) {
      sums[v] += normal;
      areas[v] += normal.norm();
    }
  }
  std::vector<double> sharp(mesh.vertices.size(), 0);
  for (std::size_t v = 0; v < sharp.size(); ++v)
    if (areas[v] > 0)
      sharp[v] = 1 - sums[v].norm() / areas[v];
  return sharp;
}

std::vector<std::uint32_t>
roomsOfVertices(const TriangleMesh& mesh)
{
  std::vector<std::uint32_t> rooms(mesh.vertices.size(), 0);
  if (!mesh.rooms.empty())
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      for (const auto v : mesh.triangles[t])
        rooms[v] = mesh.rooms[t];
  return rooms;
}

/** @brief Merges the vertices of each cell into the sharpest one. Corners and edges
 * stay in place; on a plane any vertex will do. */
TriangleMesh
clustered(const TriangleMesh& mesh,
          const std::vector<double>& sharp,
          const std::vector<std::uint32_t>& rooms,
          double size)
{
  using Key = std::tuple<std::uint32_t, std::int64_t, std::int64_t, std::int64_t>;
  constexpr double same = 0.02; // smaller differences keep the first
  std::map<Key, std::uint32_t> cells;
  std::vector<Key> keys(mesh.vertices.size());
  for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
    const Eigen::Vector3d place = mesh.vertices[v] / size;
    keys[v] = {rooms[v], std::llround(std::floor(place.x())),
               std::llround(std::floor(place.y())),
               std::llround(std::floor(place.z()))};
    const auto [cell, is_new] = cells.emplace(keys[v], v);
    if (!is_new && sharp[v] > sharp[cell->second] + same)
      cell->second = v;
  }
  TriangleMesh reduced = mesh;
  std::vector<bool> keep(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    Triangle& triangle = reduced.triangles[t];
    for (auto& v : triangle)
      v = cells[keys[v]];
    keep[t] = triangle[0] != triangle[1] && triangle[1] != triangle[2] &&
              triangle[2] != triangle[0];
  }
  reduced.keepTriangles(keep);
  reduced.removeUnusedVertices();
  return reduced;
}

} // namespace

TriangleMesh
reducedMesh(const TriangleMesh& mesh, std::size_t most)
{
  if (mesh.triangles.size() <= most)
    return mesh;
  const auto sharp = sharpness(mesh);
  const auto rooms = roomsOfVertices(mesh);
  // A plane in cells of size s has two triangles per cell.
  double size = std::sqrt(2 * mesh.area() / static_cast<double>(most));
  constexpr double growth = 1.15;
  TriangleMesh reduced = clustered(mesh, sharp, rooms, size);
  while (reduced.triangles.size() > most) {
    size *= growth;
    reduced = clustered(mesh, sharp, rooms, size);
  }
  return reduced;
}

} // namespace pcl::sedr::tools
