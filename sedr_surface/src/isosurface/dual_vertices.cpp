// SPDX-License-Identifier: BSD-3-Clause
#include "dual_vertices.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
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
constexpr std::array<CellEdge, 12> cell_edges = {{{0, 0},
                                                  {2, 0},
                                                  {4, 0},
                                                  {6, 0},
                                                  {0, 1},
                                                  {1, 1},
                                                  {4, 1},
                                                  {5, 1},
                                                  {0, 2},
                                                  {1, 2},
                                                  {2, 2},
                                                  {3, 2}}};

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

} // namespace

Eigen::Vector3f
DualVertices::slopeAt(const std::array<int, 3>& node) const
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

const SurfacePlane&
DualVertices::planeAt(const std::array<int, 3>& node, int axis)
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

Eigen::Vector3f
DualVertices::meet(const Eigen::Vector3f& centre, SurfaceVertex& vertex) const
{
  constexpr float flat = 0.05f;   // share of squared normals, at an edge of 25 degrees
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

void
DualVertices::place(std::size_t b,
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

} // namespace pcl::sedr
