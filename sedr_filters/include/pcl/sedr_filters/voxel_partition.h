// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/point_view.h>
#include <pcl/types.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Voxel coordinates of a finite point: floor(p * inverse_leaf) in the float
 * arithmetic of pcl::VoxelGrid, saturated to the range of an int. */
Eigen::Vector3i voxelOf(const Eigen::Vector3f& p, const Eigen::Array3f& inverse_leaf);

/** @brief The points of a cloud by voxel. */
struct VoxelPartition {
  pcl::Indices order; ///< finite points, voxel after voxel (by z, then y, then x),
                      ///< within a voxel in the order they were given
  std::vector<std::size_t>
      begin; ///< of each voxel in `order`; one more, its size, at the end
  Eigen::Vector3i min = Eigen::Vector3i::Zero(); ///< smallest voxel coordinates
  Eigen::Vector3i max = Eigen::Vector3i::Zero(); ///< largest voxel coordinates

  std::size_t size() const { return begin.empty() ? 0 : begin.size() - 1; }

  std::size_t pointsIn(std::size_t voxel) const
  {
    return begin[voxel + 1] - begin[voxel];
  }
};

/** @brief Sorts `points[indices]` into voxels (paper, section 2.2).
 *
 * Any extent works: nothing is as large as the bounding box. Non-finite points are left
 * out. O(n) but for the sorting of voxels within a row, the same result for any number
 * of threads.
 * @param indices must be within the cloud
 * @param inverse_leaf one over the edges of a voxel, per metre, finite and > 0
 * @param threads 0 = all */
VoxelPartition partitionVoxels(const PointView& points,
                               const pcl::Indices& indices,
                               const Eigen::Array3f& inverse_leaf,
                               unsigned threads);

} // namespace sedr
} // namespace pcl
