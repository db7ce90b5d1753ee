// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "block_directory.h"
#include "held_blocks.h"
#include "voxel_batch.h"

#include <pcl/sedr_filters/point_view.h>

#include <algorithm>
#include <array>
#include <mutex>

namespace pcl::sedr {

/** @brief Adds the points of one thread to the blocks shared by all threads.
 *
 * A scanner alternates between a few blocks before it moves on. So a block is usually
 * locked once for all of its points in a batch, and found in the cache of recent
 * blocks. Points in random order would each wait four times for memory; then the blocks
 * and sums of a whole batch are prefetched. */
class VoxelAdder {
public:
  VoxelAdder(const VoxelFrame& frame, BlockDirectory& blocks)
      : frame_(frame)
      , blocks_(blocks)
      , held_(blocks.meetings)
  {}

  /** @brief Adds points[index_of(k)] for k from `begin` to `end`. */
  template <typename IndexOf>
  void add(const PointView& points,
           std::size_t begin,
           std::size_t end,
           const IndexOf& index_of)
  {
    for (std::size_t k = begin; k < end; k += VoxelBatch::most) {
      const std::size_t n = std::min(VoxelBatch::most, end - k);
      batch_.fill(n, [&](std::size_t i) {
        points.prefetch(index_of(std::min(k + i + VoxelBatch::most, end - 1)));
        return points[index_of(k + i)];
      });
      addBatch();
    }
  }

  /** @brief Adds a finished sum; its count must not be 0. */
  void add(const VoxelSum& voxel)
  {
    const VoxelCode corner = VoxelBlock::cornerOf(voxel.code);
    VoxelBlock& block = blockAt(corner, RecentBlocks::slotOf(corner));
    const std::lock_guard<VoxelBlock> lock(block);
    BlockSum& sum = sumOf(block, VoxelBlock::localOf(voxel.code));
    sum.count += voxel.count;
    for (std::size_t axis = 0; axis < 3; ++axis)
      sum.steps[axis] += voxel.sum[axis];
  }

private:
  struct ReleaseAtEnd {
    ~ReleaseAtEnd() { held.release(); }
    HeldBlocks& held;
  };

  void addBatch()
  {
    batch_.find(frame_);
    if (is_scattered_)
      lookAhead();
    held_.begin();
    const std::size_t held_before = held_.count();
    const ReleaseAtEnd at_end{held_};
    for (std::size_t i = 0; i < batch_.size(); ++i) {
      VoxelBlock* block = held_.find(batch_.slot(i), batch_.corner(i));
      if (!block)
        block = &hold(i);
      BlockSum& sum = sumOf(*block, batch_.local(i));
      ++sum.count;
      for (std::size_t axis = 0; axis < 3; ++axis)
        sum.steps[axis] += batch_.steps(axis, i);
    }
    is_scattered_ = 2 * (held_.count() - held_before) > batch_.size();
  }

  /** @brief Locks the block of a point, which is not held yet. */
  VoxelBlock& hold(std::size_t i)
  {
    VoxelBlock& block = is_scattered_ && guesses_[i]
                            ? *guesses_[i]
                            : blockAt(batch_.corner(i), batch_.slot(i));
    held_.hold(block, batch_.slot(i));
    return block;
  }

  /** @brief Finds the blocks of a batch and prefetches their sums. */
  void lookAhead()
  {
    const std::size_t n = batch_.size();
    for (std::size_t i = 0; i < n; ++i) {
      hashes_[i] = hashOf(batch_.corner(i));
      prefetch(blocks_.placeOf(hashes_[i]));
    }
    for (std::size_t i = 0; i < n; ++i)
      if (const VoxelBlock* const guess = blocks_.guess(hashes_[i])) {
        prefetch(guess);
        prefetch(reinterpret_cast<const char*>(guess + 1) - 1);
      }
    for (std::size_t i = 0; i < n; ++i) {
      guesses_[i] = blocks_.find(batch_.corner(i), hashes_[i]);
      if (!guesses_[i])
        continue;
      const unsigned place = guesses_[i]->placeOf(batch_.local(i));
      const auto* const sums = guesses_[i]->sums.load(std::memory_order_relaxed);
      if (place > 0)
        prefetch(sums + place - 1);
    }
  }

  VoxelBlock& blockAt(const VoxelCode& corner, std::size_t slot)
  {
    VoxelBlock* block = recent_.find(slot, corner);
    if (!block)
      block = recent_.at(slot) = &blocks_.find(corner, memory_);
    return *block;
  }

  BlockSum& sumOf(VoxelBlock& block, unsigned local)
  {
    const unsigned place = block.placeOf(local);
    return place > 0 ? block.sums.load(std::memory_order_relaxed)[place - 1]
                     : memory_.makeSum(block, local);
  }

  const VoxelFrame& frame_;
  BlockDirectory& blocks_;
  BlockMemory memory_;
  VoxelBatch batch_;
  bool is_scattered_ = false; ///< fewer than two points for each lock
  std::array<std::uint32_t, VoxelBatch::most> hashes_{};
  std::array<VoxelBlock*, VoxelBatch::most> guesses_{};
  RecentBlocks recent_;
  HeldBlocks held_;
};

} // namespace pcl::sedr
