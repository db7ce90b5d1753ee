// SPDX-License-Identifier: BSD-3-Clause
#include "dual_surface.h"

#include "sedr_filters/src/base/parallel.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pcl::sedr {
namespace {

constexpr int strides[3] = {1, 10, 100};

// The twelve edges of a cell: lowest corner and axis.
struct CellEdge {
  int corner;
  int axis;
};
constexpr std::array<CellEdge, 12> cell_edges = [] {
  std::array<CellEdge, 12> edges{};
  for (int k = 0; k < 12; ++k) {
    const int axis = k / 4;
    const int u = axis == 0 ? 1 : 0; // the other axes
    const int v = axis == 2 ? 1 : 2;
    edges[static_cast<std::size_t>(k)] = {(k & 1) << u | (k >> 1 & 1) << v, axis};
  }
  return edges;
}();

// Returns the mean normal, counting each face once, however many planes it has.
Eigen::Vector3f
meanOfFaces(const std::vector<SurfacePlane>& planes)
{
  constexpr float same = 0.9f; // cosine of 25 degrees
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  for (std::size_t i = 0; i < planes.size(); ++i) {
    bool is_new = true;
    for (std::size_t j = 0; j < i && is_new; ++j)
      is_new = planes[i].normal.dot(planes[j].normal) < same;
    if (is_new)
      sum += planes[i].normal;
  }
  return sum.norm() > 0 ? Eigen::Vector3f(sum.normalized()) : planes.front().normal;
}

/** @brief Places the vertices of a dual surface, block by block. */
class DualVertices {
public:
  DualVertices(const BandGrid& grid,
               const std::vector<float>& values,
               const SortedSamples& samples,
               float radius)
      : grid_(grid)
      , values_(values)
      , samples_(samples)
      , planes_(radius)
  {}

  /** @brief Places the vertices of a block's cells.
   * @param table the vertex of each of the 512 cells, or the largest number if none
   * @param places positions of all vertices of the mesh, in cells
   * @param vertices properties of each vertex */
  void place(std::size_t b,
             const std::uint32_t* table,
             Eigen::Vector3d* places,
             SurfaceVertex* vertices)
  {
    grid_.gatherHalo(values_, b, halo_.data());
    planes_.load(grid_, b, samples_);
    known_.fill(-1);
    found_.clear();
    const BandGrid::Block block = grid_.at(b);
    const Eigen::Vector3d origin(static_cast<double>(block[0] * BandGrid::edge),
                                 static_cast<double>(block[1] * BandGrid::edge),
                                 static_cast<double>(block[2] * BandGrid::edge));
    for (int i = 0; i < static_cast<int>(BandGrid::nodes); ++i) {
      const std::uint32_t vertex = table[i];
      if (vertex == std::numeric_limits<std::uint32_t>::max())
        continue;
      const std::array<int, 3> cell = {i & 7, i >> 3 & 7, i >> 6};
      cell_planes_.clear();
      for (const CellEdge& edge : cell_edges) {
        const std::array<int, 3> node = {cell[0] + (edge.corner & 1),
                                         cell[1] + (edge.corner >> 1 & 1),
                                         cell[2] + (edge.corner >> 2)};
        const std::size_t here = BandGrid::haloIndex(node[0], node[1], node[2]);
        if ((halo_[here] > 0) !=
            (halo_[here + static_cast<std::size_t>(strides[edge.axis])] > 0))
          cell_planes_.push_back(planeAt(node, edge.axis));
      }
      const Eigen::Vector3f centre(static_cast<float>(cell[0]) + 0.5f,
                                   static_cast<float>(cell[1]) + 0.5f,
                                   static_cast<float>(cell[2]) + 0.5f);
      places[vertex] = origin + meet(centre, vertices[vertex]).cast<double>();
    }
  }

private:
  const SurfacePlane& planeAt(const std::array<int, 3>& node, int axis)
  {
    const auto id =
        static_cast<std::size_t>(((node[2] * 9 + node[1]) * 9 + node[0]) * 3 + axis);
    if (known_[id] >= 0)
      return found_[static_cast<std::size_t>(known_[id])];
    known_[id] = static_cast<std::int16_t>(found_.size());
    const std::size_t here = BandGrid::haloIndex(node[0], node[1], node[2]);
    const float from = halo_[here];
    const float to = halo_[here + static_cast<std::size_t>(strides[axis])];
    std::array<int, 3> end = node;
    ++end[static_cast<std::size_t>(axis)];
    Eigen::Vector3f place(static_cast<float>(node[0]), static_cast<float>(node[1]),
                          static_cast<float>(node[2]));
    place[axis] += std::min(std::max(from / (from - to), 0.02f), 0.98f);
    const Eigen::Vector3f slope = slopeAt(node) + slopeAt(end);
    SurfacePlane plane;
    if (!planes_.find(place, slope, plane) || (plane.point - place).norm() > 1.5f) {
      plane.point = place;
      plane.normal = slope.norm() > 0 ? Eigen::Vector3f(slope.normalized())
                                      : Eigen::Vector3f::Unit(axis);
    }
    found_.push_back(plane);
    return found_.back();
  }

  Eigen::Vector3f slopeAt(const std::array<int, 3>& node) const
  {
    const std::size_t here = BandGrid::haloIndex(node[0], node[1], node[2]);
    Eigen::Vector3f slope;
    for (int k = 0; k < 3; ++k) {
      const auto step = static_cast<std::size_t>(strides[k]);
      const bool last = node[static_cast<std::size_t>(k)] == 8;
      slope[k] =
          (halo_[last ? here : here + step] - halo_[here - step]) * (last ? 2.f : 1.f);
    }
    return slope;
  }

  Eigen::Vector3f meet(const Eigen::Vector3f& centre, SurfaceVertex& vertex) const
  {
    constexpr float flat = 0.05f; // share of squared normals, at an edge of 25 degrees
    constexpr float farthest = 1.f; // cells from the centre of the cell, along an axis
    Eigen::Vector3f mean = Eigen::Vector3f::Zero();
    for (const SurfacePlane& plane : cell_planes_)
      mean += plane.point;
    mean /= static_cast<float>(cell_planes_.size());
    Eigen::Matrix3f squares = Eigen::Matrix3f::Zero();
    Eigen::Vector3f right = Eigen::Vector3f::Zero();
    for (const SurfacePlane& plane : cell_planes_) {
      squares += plane.normal * plane.normal.transpose();
      right += plane.normal * plane.normal.dot(plane.point - mean);
    }
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> solver;
    solver.computeDirect(squares);
    Eigen::Vector3f shift = Eigen::Vector3f::Zero();
    int rank = 0;
    for (int k = 2; k >= 0; --k) {
      if (solver.eigenvalues()[k] < flat * solver.eigenvalues()[2])
        break;
      const Eigen::Vector3f axis = solver.eigenvectors().col(k);
      shift += axis * (axis.dot(right) / solver.eigenvalues()[k]);
      ++rank;
    }
    vertex.sharpness = static_cast<std::uint8_t>(rank - 1);
    // On a curved face, the mean lies as far inside as the planes' intersection lies
    // outside.
    if (rank == 1)
      shift /= 2;
    vertex.line = solver.eigenvectors().col(0);
    vertex.normal = meanOfFaces(cell_planes_);
    // Limits the distance from the cell to what the rounding of the function may cause.
    float share = 1;
    for (int k = 0; k < 3; ++k) {
      const float from = mean[k] - centre[k];
      const float to = from + shift[k];
      if (std::abs(to) > farthest && std::abs(to) > std::abs(from))
        share = std::min(share, std::max(0.f, (farthest - std::abs(from)) /
                                                  (std::abs(to) - std::abs(from))));
    }
    return mean + share * shift;
  }

  const BandGrid& grid_;
  const std::vector<float>& values_;
  const SortedSamples& samples_;
  SurfacePlanes planes_;
  std::array<float, BandGrid::halo_nodes> halo_;
  std::array<std::int16_t, 3 * 729> known_; ///< plane of each edge, or -1
  std::vector<SurfacePlane> found_;
  std::vector<SurfacePlane> cell_planes_;
};

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
  parallelFor(grid.size(), BandGrid::blocks_at_once, threads, [&](std::size_t b) {
    addTriangles(grid, values, cells, b, mesh, vertices,
                 parts[b / BandGrid::blocks_at_once]);
  });
  for (const auto& part : parts)
    mesh.triangles.insert(mesh.triangles.end(), part.begin(), part.end());
}

} // namespace pcl::sedr
