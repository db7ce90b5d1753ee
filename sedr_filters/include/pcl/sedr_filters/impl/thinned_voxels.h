// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/point_view.h>
#include <pcl/types.h>

#include <cstddef>
#include <functional>
#include <memory>

namespace pcl::sedr {

class VoxelIndex;
class VoxelSums;

/** @brief The voxels kept by VoxelGridSettings::thin(): first their means, then which
 * input points lie in which voxel. */
class ThinnedVoxels {
public:
  /** @param sums already arranged
   * @param size number of voxels kept
   * @param threads 0: all processors */
  ThinnedVoxels(std::unique_ptr<VoxelSums> sums, std::size_t size, unsigned threads);
  ThinnedVoxels(ThinnedVoxels&&) noexcept;
  ~ThinnedVoxels();

  std::size_t size() const { return size_; }

  /** @brief Touches memory that will soon be written, on all threads, to map it. */
  void takeMemory(void* begin, std::size_t bytes) const;

  /** @brief Writes the mean of each voxel: x, y and z as floats, the first at
   * `first_x`, `stride` bytes from one voxel to the next. Must be called before
   * sortPoints(). */
  void writeMeans(void* first_x, std::size_t stride) const;

  /** @brief Prepares contains() and forEachPoint(), and frees the sums. */
  void sortPoints();

  /** @brief Checks whether a point lies in one of the voxels. */
  bool contains(const Eigen::Vector3f& point) const;

  /** @brief Calls `see(voxel, i)` for every point i in one of the voxels; the points of
   * a voxel in order and from one thread.
   * @param indices the points to use; null: all */
  void forEachPoint(const PointView& points,
                    const pcl::Indices* indices,
                    const std::function<void(std::size_t, std::size_t)>& see) const;

  /** @brief Calls `see(begin, end)` for ranges of voxels, on all threads. */
  void forEachStretch(const std::function<void(std::size_t, std::size_t)>& see) const;

private:
  std::unique_ptr<VoxelSums> sums_;
  std::unique_ptr<VoxelIndex> index_;
  std::size_t size_;
  unsigned threads_;
};

} // namespace pcl::sedr
