// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../base/large_memory.h"
#include "voxel_block.h"

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <new>
#include <vector>

namespace pcl::sedr {

/** @brief Memory for the blocks and sums created by one thread: allocated in large
 * portions and released all at once. */
class BlockMemory {
public:
  VoxelBlock& makeBlock(const VoxelCode& corner)
  {
    return *new (take(sizeof(VoxelBlock))) VoxelBlock(corner);
  }

  /** @brief Creates the sum of a voxel that has none; the block must be locked. */
  BlockSum& makeSum(VoxelBlock& block, unsigned local)
  {
    if (block.size == rooms[block.room_class])
      moveToLargerRoom(block);
    BlockSum& sum = block.sums.load(std::memory_order_relaxed)[block.size++];
    sum = {{0, 0, 0}, 0, local};
    block.places[local].store(block.size, std::memory_order_relaxed);
    block.occupied |= std::uint64_t{1} << local;
    return sum;
  }

private:
  /** @brief Capacities of the storage of a block, in sums. */
  static constexpr std::array<std::uint8_t, 12> rooms{0,  1,  2,  4,  6,  8,
                                                      12, 16, 24, 32, 48, 64};
  static constexpr std::size_t min_portion = std::size_t{1} << 16;

  /** @brief Entry of the free list, stored in unused storage. */
  struct LeftRoom {
    LeftRoom* next;
  };

  void moveToLargerRoom(VoxelBlock& block)
  {
    const BlockSum* const old = block.sums.load(std::memory_order_relaxed);
    BlockSum* const larger = makeRoom(block.room_class + std::size_t{1});
    std::copy(old, old + block.size, larger);
    block.sums.store(larger, std::memory_order_relaxed);
    if (old)
      left_rooms_[block.room_class] =
          new (const_cast<BlockSum*>(old)) LeftRoom{left_rooms_[block.room_class]};
    ++block.room_class;
  }

  /** @brief Returns storage from the free list, or new storage. */
  BlockSum* makeRoom(std::size_t room_class)
  {
    void* room = left_rooms_[room_class];
    if (room)
      left_rooms_[room_class] = left_rooms_[room_class]->next;
    else
      room = take(rooms[room_class] * sizeof(BlockSum));
    return new (room) BlockSum[rooms[room_class]];
  }

  void* take(std::size_t bytes)
  {
    if (free_ < bytes) {
      const std::size_t portion = std::clamp(taken_, min_portion, large_page);
      portions_.emplace_back(static_cast<char*>(std::aligned_alloc(portion, portion)),
                             &std::free);
      if (!portions_.back())
        throw std::bad_alloc();
      expectLarge(portions_.back().get(), portion);
      taken_ += portion;
      next_ = portions_.back().get();
      free_ = portion;
    }
    void* const place = next_;
    next_ += bytes;
    free_ -= bytes;
    return place;
  }

  std::vector<std::unique_ptr<char, decltype(&std::free)>> portions_;
  std::size_t taken_ = 0; ///< bytes allocated in total
  char* next_ = nullptr;
  std::size_t free_ = 0; ///< bytes free from `next_` on
  std::array<LeftRoom*, rooms.size()> left_rooms_{};
};

} // namespace pcl::sedr
