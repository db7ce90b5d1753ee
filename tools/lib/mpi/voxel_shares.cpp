// SPDX-License-Identifier: BSD-3-Clause
#include "voxel_shares.h"

#include "sedr_filters/src/voxels/voxel_sums.h"

#include <algorithm>

namespace pcl::sedr::tools {

namespace {

bool
precedes(const VoxelKey& a, const VoxelKey& b)
{
  return isBefore(VoxelSum{a, 0, {}}, VoxelSum{b, 0, {}});
}

} // namespace

std::vector<VoxelKey>
keysOf(const std::vector<VoxelSum>& voxels)
{
  constexpr std::size_t step = 256;
  std::vector<VoxelKey> keys;
  for (std::size_t i = 0; i < voxels.size(); i += step)
    keys.push_back(voxels[i].code);
  return keys;
}

std::vector<VoxelKey>
bordersOf(std::vector<VoxelKey> keys, std::size_t ranks)
{
  std::sort(keys.begin(), keys.end(), precedes);
  std::vector<VoxelKey> borders;
  for (std::size_t r = 1; r < ranks && !keys.empty(); ++r)
    borders.push_back(keys[keys.size() * r / ranks]);
  return borders;
}

std::vector<std::size_t>
sharesOf(const std::vector<VoxelSum>& voxels, const std::vector<VoxelKey>& borders)
{
  std::vector<std::size_t> begins{0};
  for (const VoxelKey& border : borders)
    begins.push_back(
        static_cast<std::size_t>(std::lower_bound(voxels.begin(), voxels.end(),
                                                  VoxelSum{border, 0, {}}, isBefore) -
                                 voxels.begin()));
  begins.push_back(voxels.size());
  return begins;
}

} // namespace pcl::sedr::tools
