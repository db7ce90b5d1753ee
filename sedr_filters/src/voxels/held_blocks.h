// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "recent_blocks.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace pcl::sedr {

/** @brief The blocks locked by one thread. It keeps its locks while it adds points to a
 * few adjacent blocks, between which a scanner alternates. Before it waits for a block
 * it releases all of them, so two threads never wait for each other. It may wait for
 * memory and for the directory while it holds blocks: their owners never wait for a
 * block. */
class HeldBlocks {
public:
  /** @param meetings counts how often a thread had to wait for another */
  explicit HeldBlocks(std::atomic<std::uint32_t>& meetings)
      : meetings_(meetings)
  {}
  HeldBlocks(const HeldBlocks&) = delete;
  HeldBlocks& operator=(const HeldBlocks&) = delete;

  /** @brief Returns the block with this corner, null if it is not held. */
  VoxelBlock* find(std::size_t slot, const VoxelCode& corner) const
  {
    return by_slot_.find(slot, corner);
  }

  /** @brief Locks a block that is not held. */
  void hold(VoxelBlock& block, std::size_t slot)
  {
    if (size_ >= max_ || by_slot_.at(slot))
      release();
    if (!block.tryLock()) {
      release();
      ++meetings_;
      block.lock();
    }
    by_slot_.at(slot) = &block;
    slots_[size_++] = slot;
    ++count_;
  }

  void release()
  {
    while (size_ > 0) {
      VoxelBlock*& block = by_slot_.at(slots_[--size_]);
      block->unlock();
      block = nullptr;
    }
  }

  /** @brief Starts a batch of points. If threads met in a block since the last call,
   * only one block is held at a time for a while. */
  void begin()
  {
    const std::uint32_t meetings = meetings_.load(std::memory_order_relaxed);
    max_ = meetings != seen_meetings_ ? 1 : std::min(2 * max_, most);
    seen_meetings_ = meetings;
  }

  /** @brief Returns the number of locks taken so far. */
  std::size_t count() const { return count_; }

private:
  static constexpr std::size_t most = 32;

  std::atomic<std::uint32_t>& meetings_;
  std::uint32_t seen_meetings_ = 0;
  std::size_t max_ = most;
  RecentBlocks by_slot_;
  std::array<std::size_t, most> slots_{};
  std::size_t size_ = 0;
  std::size_t count_ = 0;
};

} // namespace pcl::sedr
