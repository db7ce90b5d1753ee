// SPDX-License-Identifier: BSD-3-Clause
#include "voxel_index.h"
#include "voxel_hash.h"

namespace pcl::sedr {

VoxelIndex::VoxelIndex(const VoxelFrame& frame, const std::vector<VoxelSum>& voxels)
    : frame_(frame)
    , voxels_(voxels)
    , slots_(2 * voxels.size() + 1, 0)
{
  for (std::size_t v = 0; v < voxels.size(); ++v)
    slots_[slotOf(voxels[v].code)] = static_cast<std::uint32_t>(v + 1);
}

std::int64_t
VoxelIndex::find(const Eigen::Vector3f& point) const
{
  return point.allFinite()
             ? std::int64_t{slots_[slotOf(frame_.codes(point.data()))]} - 1
             : -1;
}

std::size_t
VoxelIndex::slotOf(const VoxelCode& code) const
{
  std::size_t i = static_cast<std::size_t>(
      (static_cast<std::uint64_t>(hashOf(code)) * slots_.size()) >> 32);
  while (slots_[i] != 0 && !isSame(voxels_[slots_[i] - 1].code, code))
    i = i + 1 == slots_.size() ? 0 : i + 1;
  return i;
}

} // namespace pcl::sedr
