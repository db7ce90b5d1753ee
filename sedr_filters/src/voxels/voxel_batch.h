// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "voxel_blocks.h"

#include <pcl/sedr_filters/point_view.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <mutex>

namespace pcl::sedr {

/** @brief A batch of points, sorted by their blocks: each block is looked up and locked
 * once for all of its points. A thread has one lock at a time, so no two threads wait
 * for each other. */
class VoxelBatch {
public:
  static constexpr std::size_t most = 1024;

  /** @brief Takes the finite points among points[index_of(k)], k from `begin` to `end`,
   * at most `most`. */
  template <typename IndexOf>
  void fill(const PointView& points,
            std::size_t begin,
            std::size_t end,
            const IndexOf& index_of,
            const VoxelFrame& frame)
  {
    constexpr std::size_t ahead = 64;
    size_ = 0;
    for (std::size_t k = begin; k < end; ++k) {
      points.prefetch(index_of(std::min(k + ahead, end - 1)));
      const Eigen::Vector3f point = points[index_of(k)];
      for (std::size_t axis = 0; axis < 3; ++axis)
        points_[axis][size_] = point[static_cast<Eigen::Index>(axis)];
      size_ += point.allFinite() ? 1 : 0;
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
      frame.find(axis, points_[axis].data(), size_, codes_[axis].data(),
                 steps_[axis].data());
    sortByBlocks();
  }

  void addTo(VoxelBlocks& blocks)
  {
    if (2 * groups_ > size_) { // points in random order: each waits for memory
      for (std::size_t g = 0; g < groups_; ++g)
        blocks.expect(hashes_[g]);
    }
    for (std::size_t g = 0; g < groups_; ++g)
      prefetch(found_[g] = &blocks.at(corner(first_[g]), hashes_[g]));
    if (2 * groups_ > size_)
      for (std::size_t g = 0; g < groups_; ++g) {
        const std::lock_guard<SpinLock> lock(found_[g]->lock);
        const VoxelCode voxel = code(first_[g]);
        const unsigned place = found_[g]->places[VoxelBlock::localOf(voxel)];
        prefetch(found_[g]->sums.data() + (place > 0 ? place - 1 : 0));
      }
    for (std::size_t g = 0; g < groups_; ++g) {
      const std::lock_guard<SpinLock> lock(found_[g]->lock);
      for (std::size_t i = first_[g]; i != none; i = next_[i]) {
        VoxelSum& sum = found_[g]->at(code(i));
        ++sum.count;
        for (std::size_t axis = 0; axis < 3; ++axis)
          sum.sum[axis] += steps_[axis][i];
      }
    }
  }

private:
  template <typename ValueT>
  using Column = std::array<ValueT, most>;
  template <typename ValueT>
  using Columns = std::array<Column<ValueT>, 3>;

  static constexpr std::uint16_t none = 0xffff;

  VoxelCode code(std::size_t i) const
  {
    return {codes_[0][i], codes_[1][i], codes_[2][i]};
  }

  VoxelCode corner(std::size_t i) const { return VoxelBlock::cornerOf(code(i)); }

  /** @brief Lists the points of each block. */
  void sortByBlocks()
  {
    slots_.fill(none);
    groups_ = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      const VoxelCode block = corner(i);
      const std::uint64_t hash = hashOf(block);
      std::size_t slot = hash % slots_.size();
      while (slots_[slot] != none && !isSame(corner(first_[slots_[slot]]), block))
        slot = (slot + 1) % slots_.size();
      std::uint16_t& group = slots_[slot];
      if (group == none) {
        group = static_cast<std::uint16_t>(groups_++);
        hashes_[group] = hash;
        first_[group] = none;
      }
      next_[i] = first_[group];
      first_[group] = static_cast<std::uint16_t>(i);
    }
  }

  std::size_t size_ = 0;
  Columns<float> points_;
  Columns<std::int32_t> codes_;
  Columns<std::uint64_t> steps_;
  Column<std::uint16_t> next_; ///< next point of the same block

  std::size_t groups_ = 0;                    ///< number of blocks
  std::array<std::uint16_t, 2 * most> slots_; ///< hash table of blocks
  Column<std::uint16_t> first_;               ///< first point of each block
  Column<std::uint64_t> hashes_;
  Column<VoxelBlock*> found_;
};

} // namespace pcl::sedr
