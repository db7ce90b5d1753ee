// SPDX-License-Identifier: BSD-3-Clause
#include "../base/large_memory.h"
#include "../base/parallel.h"
#include "../voxels/voxel_sums.h"
#include "../voxels/voxel_visit.h"

#include <pcl/sedr_filters/impl/thinned_voxels.h>

#include <cstring>
#include <utility>

namespace pcl::sedr {

ThinnedVoxels::ThinnedVoxels(std::unique_ptr<VoxelSums> sums,
                             std::size_t size,
                             unsigned threads)
    : sums_(std::move(sums))
    , size_(size)
    , threads_(threads)
{}

ThinnedVoxels::ThinnedVoxels(ThinnedVoxels&&) noexcept = default;
ThinnedVoxels::~ThinnedVoxels() = default;

void
ThinnedVoxels::takeMemory(void* begin, std::size_t bytes) const
{
  takeLarge(begin, bytes, threads_);
}

void
ThinnedVoxels::writeMeans(void* first_x, std::size_t stride) const
{
  sums_->forEach(
      [&](const VoxelSum& voxel, std::size_t place) {
        const Eigen::Vector3f mean = sums_->frame().mean(voxel);
        std::memcpy(static_cast<char*>(first_x) + place * stride, mean.data(),
                    sizeof mean);
      },
      threads_);
}

void
ThinnedVoxels::sortPoints()
{
  index_ = std::make_unique<VoxelIndex>(sums_->frame(), sums_->take(threads_));
}

bool
ThinnedVoxels::contains(const Eigen::Vector3f& point) const
{
  return index_->find(point) >= 0;
}

void
ThinnedVoxels::forEachPoint(
    const PointView& points,
    const pcl::Indices* indices,
    const std::function<void(std::size_t, std::size_t)>& see) const
{
  visitVoxels(*index_, points, indices, threads_, see);
}

void
ThinnedVoxels::forEachStretch(
    const std::function<void(std::size_t, std::size_t)>& see) const
{
  constexpr std::size_t voxels_at_once = 4096;
  parallelBlocks(size_, voxels_at_once, threads_, see);
}

} // namespace pcl::sedr
