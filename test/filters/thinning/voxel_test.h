// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sedr_filters/src/voxels/voxel_sums.h"

#include <vector>

/** @file Voxel sums of points in a vector. */

namespace voxel_test {

using namespace pcl::sedr;

inline PointView
viewOf(const std::vector<Eigen::Vector3f>& points)
{
  return points.empty()
             ? PointView()
             : PointView(points[0].data(), sizeof(Eigen::Vector3f), points.size());
}

inline std::vector<VoxelSum>
sumsOf(const std::vector<Eigen::Vector3f>& points,
       const Eigen::Array3f& inverse_leaf = Eigen::Array3f::Constant(20),
       unsigned threads = 1)
{
  VoxelSums sums(inverse_leaf);
  sums.add(viewOf(points), threads);
  return sums.take(threads);
}

} // namespace voxel_test
