// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surface_mending.h"
#include "surface_planes.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace pcl::sedr {

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
             SurfaceVertex* vertices);

private:
  const SurfacePlane& planeAt(const std::array<int, 3>& node, int axis);
  Eigen::Vector3f slopeAt(const std::array<int, 3>& node) const;
  Eigen::Vector3f meet(const Eigen::Vector3f& centre, SurfaceVertex& vertex) const;

  const BandGrid& grid_;
  const std::vector<float>& values_;
  const SortedSamples& samples_;
  SurfacePlanes planes_;
  std::array<float, BandGrid::halo_nodes> halo_;
  std::array<std::int16_t, 3 * 729> known_; ///< plane of each edge, or -1
  std::vector<SurfacePlane> found_;
  std::vector<SurfacePlane> cell_planes_;
};

} // namespace pcl::sedr
