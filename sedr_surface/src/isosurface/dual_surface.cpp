// SPDX-License-Identifier: BSD-3-Clause
#include "dual_surface.h"

#include "dual_vertices.h"

#include "sedr_filters/src/base/parallel.h"
#include "sedr_filters/src/base/parallel_for.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pcl::sedr {
namespace {

constexpr auto none = std::numeric_limits<std::uint32_t>::max();

// Cells that hold a vertex, and its index.
struct CellVertices {
  std::vector<std::uint32_t> table; // per block with a vertex, for its 512 cells
  std::vector<std::size_t> row;     // of the table, per block
  std::vector<std::size_t> blocks;  // blocks with a vertex
  std::uint32_t count = 0;          // of vertices
};

CellVertices
numberCells(const BandGrid& grid, const std::vector<float>& values, unsigned threads)
{
  std::vector<std::vector<std::uint16_t>> crossed(grid.size());
  parallelFor(grid.size(), BandGrid::blocks_at_once, threads, [&](std::size_t b) {
    float halo[BandGrid::halo_nodes];
    grid.gatherHalo(values, b, halo);
    if (!isHaloCrossed(halo, 0))
      return;
    for (int i = 0; i < static_cast<int>(BandGrid::nodes); ++i) {
      const int n[3] = {i & 7, i >> 3 & 7, i >> 6};
      // Counting values around the band, cells at the rim have one sign.
      if (isCrossed(halo + BandGrid::haloIndex(n[0], n[1], n[2]), 0) &&
          grid.holdsCell(b, n[0], n[1], n[2]))
        crossed[b].push_back(static_cast<std::uint16_t>(i));
    }
  });
  CellVertices cells;
  cells.row.assign(grid.size(), grid.size());
  for (std::size_t b = 0; b < grid.size(); ++b) {
    if (crossed[b].empty())
      continue;
    cells.row[b] = cells.blocks.size();
    cells.blocks.push_back(b);
    cells.table.resize(cells.blocks.size() * BandGrid::nodes, none);
    for (const std::uint16_t i : crossed[b])
      cells.table[cells.row[b] * BandGrid::nodes + i] = cells.count++;
  }
  return cells;
}

std::uint32_t
vertexOf(const BandGrid& grid,
         const CellVertices& cells,
         std::size_t b,
         const std::array<int, 3>& cell)
{
  const std::size_t block = grid.blockAt(b, cell[0], cell[1], cell[2]);
  if (block == grid.size() || cells.row[block] == grid.size())
    return none;
  return cells.table[cells.row[block] * BandGrid::nodes +
                     BandGrid::nodeIndex(cell[0] & 7, cell[1] & 7, cell[2] & 7)];
}

// Cuts a quad along the diagonal that follows an edge of the surface, otherwise along
// the shorter one, unless that would turn a triangle away from `towards`.
void
cutQuad(const std::array<std::uint32_t, 4>& quad,
        const TriangleMesh& mesh,
        const std::vector<SurfaceVertex>& vertices,
        std::vector<Triangle>& triangles)
{
  const auto corner = [&](std::size_t i) -> const Eigen::Vector3d& {
    return mesh.vertices[quad[i]];
  };
  const auto normal = [&](std::size_t i, std::size_t j, std::size_t k) {
    return Eigen::Vector3d((corner(j) - corner(i)).cross(corner(k) - corner(i)));
  };
  // Rates a cut by the agreement of its triangles' normals and by their thinness.
  const auto rate = [&](std::size_t i) {
    const Eigen::Vector3d a = normal(i, i + 1, (i + 2) % 4);
    const Eigen::Vector3d b = normal(i, (i + 2) % 4, (i + 3) % 4);
    const double lengths = a.norm() * b.norm();
    return lengths > 1e-12 ? a.dot(b) / lengths : -1;
  };
  const int sharp[2] = {vertices[quad[0]].sharpness + vertices[quad[2]].sharpness,
                        vertices[quad[1]].sharpness + vertices[quad[3]].sharpness};
  const double lengths[2] = {(corner(0) - corner(2)).norm(),
                             (corner(1) - corner(3)).norm()};
  const double rates[2] = {rate(0), rate(1)};
  bool second = lengths[1] < lengths[0];
  if (std::abs(rates[0] - rates[1]) > 0.2)
    second = rates[1] > rates[0];
  if (sharp[0] != sharp[1] && std::min(rates[0], rates[1]) > -0.5)
    second = sharp[1] > sharp[0];
  if (second) {
    triangles.push_back({quad[0], quad[1], quad[3]});
    triangles.push_back({quad[1], quad[2], quad[3]});
  }
  else {
    triangles.push_back({quad[0], quad[1], quad[2]});
    triangles.push_back({quad[0], quad[2], quad[3]});
  }
}

// Adds the triangles across the grid's edges that begin in block `b`.
void
addTriangles(const BandGrid& grid,
             const std::vector<float>& values,
             const CellVertices& cells,
             std::size_t b,
             const TriangleMesh& mesh,
             const std::vector<SurfaceVertex>& vertices,
             std::vector<Triangle>& triangles)
{
  constexpr int strides[3] = {1, 10, 100};
  float halo[BandGrid::halo_nodes];
  grid.gatherHalo(values, b, halo);
  if (!isHaloCrossed(halo, 0))
    return;
  for (int i = 0; i < static_cast<int>(BandGrid::nodes); ++i) {
    const std::array<int, 3> n = {i & 7, i >> 3 & 7, i >> 6};
    const float* here = halo + BandGrid::haloIndex(n[0], n[1], n[2]);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const bool from_below = *here <= 0;
      if (from_below == (here[strides[axis]] <= 0))
        continue;
      const std::size_t u = (axis + 1) % 3;
      const std::size_t v = (axis + 2) % 3;
      // Counter-clockwise, seen from the edge's end.
      constexpr int around[4][2] = {{-1, -1}, {0, -1}, {0, 0}, {-1, 0}};
      std::array<std::uint32_t, 4> quad;
      for (std::size_t c = 0; c < 4; ++c) {
        std::array<int, 3> cell = n;
        cell[u] += around[c][0];
        cell[v] += around[c][1];
        quad[from_below ? c : 3 - c] = vertexOf(grid, cells, b, cell);
      }
      if (std::find(quad.begin(), quad.end(), none) == quad.end())
        cutQuad(quad, mesh, vertices, triangles);
    }
  }
}

} // namespace

void
extractDualSurface(const BandGrid& grid,
                   const std::vector<float>& values,
                   const SortedSamples& samples,
                   float radius,
                   unsigned threads,
                   TriangleMesh& mesh,
                   std::vector<SurfaceVertex>& vertices)
{
  mesh = TriangleMesh();
  const CellVertices cells = numberCells(grid, values, threads);
  mesh.vertices.resize(cells.count);
  vertices.assign(mesh.vertices.size(), {});
  parallelBlocks(cells.blocks.size(), BandGrid::blocks_at_once, threads,
                 [&](std::size_t begin, std::size_t end) {
                   DualVertices placer(grid, values, samples, radius);
                   for (std::size_t s = begin; s < end; ++s)
                     placer.place(cells.blocks[s], &cells.table[s * BandGrid::nodes],
                                  mesh.vertices.data(), vertices.data());
                 });
  std::vector<std::vector<Triangle>> parts(
      (grid.size() + BandGrid::blocks_at_once - 1) / BandGrid::blocks_at_once);
  parallelBlocks(grid.size(), BandGrid::blocks_at_once, threads,
                 [&](std::size_t begin, std::size_t end) {
                   for (std::size_t b = begin; b < end; ++b)
                     addTriangles(grid, values, cells, b, mesh, vertices,
                                  parts[begin / BandGrid::blocks_at_once]);
                 });
  for (const auto& part : parts)
    mesh.triangles.insert(mesh.triangles.end(), part.begin(), part.end());
}

} // namespace pcl::sedr
