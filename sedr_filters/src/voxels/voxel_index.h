// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "voxel_hash.h"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace pcl::sedr {

/** @brief An index to find the voxel of a point among the output of VoxelSums. 8 bytes
 * a voxel. */
class VoxelIndex {
public:
  VoxelIndex(const VoxelFrame& frame, std::vector<VoxelSum> voxels)
      : frame_(frame)
      , voxels_(std::move(voxels))
      , slots_(2 * voxels_.size() + 1, 0)
  {
    for (std::size_t v = 0; v < voxels_.size(); ++v)
      slots_[slotOf(voxels_[v].code)] = static_cast<std::uint32_t>(v + 1);
  }

  const std::vector<VoxelSum>& voxels() const { return voxels_; }

  /** @brief Returns the index of the voxel that holds a point, -1 if there is none or
   * the point is not finite. */
  std::int64_t find(const Eigen::Vector3f& point) const
  {
    return point.allFinite()
               ? std::int64_t{slots_[slotOf(frame_.codes(point.data()))]} - 1
               : -1;
  }

private:
  std::size_t slotOf(const VoxelCode& code) const
  {
    std::size_t i = ((hashOf(code) >> 32) * slots_.size()) >> 32;
    while (slots_[i] != 0 && !isSame(voxels_[slots_[i] - 1].code, code))
      i = i + 1 == slots_.size() ? 0 : i + 1;
    return i;
  }

  VoxelFrame frame_;
  std::vector<VoxelSum> voxels_;
  std::vector<std::uint32_t> slots_; ///< index of a voxel plus one; 0: empty
};

} // namespace pcl::sedr
