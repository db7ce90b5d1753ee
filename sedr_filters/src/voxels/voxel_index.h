// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "voxel_frame.h"
#include <pcl/sedr_filters/point_view.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief An index to find the voxel of a point among the output of VoxelSums. 8 bytes
 * a voxel. */
class VoxelIndex {
public:
  /** @param voxels must outlive this object */
  VoxelIndex(const VoxelFrame& frame, const std::vector<VoxelSum>& voxels);

  /** @brief Returns the index of the voxel that holds a point, -1 if there is none or
   * the point is not finite. */
  std::int64_t find(const Eigen::Vector3f& point) const;

private:
  std::size_t slotOf(const std::array<std::int32_t, 3>& code) const;

  VoxelFrame frame_;
  const std::vector<VoxelSum>& voxels_;
  std::vector<std::uint32_t> slots_; ///< index of a voxel plus one; 0: empty
};

} // namespace pcl::sedr
