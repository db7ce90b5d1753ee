// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "block_memory.h"

#include "voxel_hash.h"

#include <atomic>
#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Finds blocks by their corner: a hash table, at most half full, that all
 * threads share. To find a block nobody waits; blocks are made one at a time. A table
 * that has become too small stays until the end, for others may still look into it. */
class BlockDirectory {
public:
  BlockDirectory()
  {
    tables_.emplace_back(new Table(1024));
    newest_ = tables_.back().get();
  }

  /** @brief How many blocks there are, while none is made. */
  std::size_t size() const { return size_; }

  /** @brief Shows all blocks, while none is made. */
  template <typename See>
  void forEach(const See& see) const
  {
    const Table& table = *tables_.back();
    for (std::size_t slot = 0; slot <= table.mask; ++slot)
      if (VoxelBlock* const block = table.at(slot))
        see(*block);
  }

  /** @brief The block with this corner, made in `memory` if there is none. */
  VoxelBlock& find(const VoxelCode& corner, BlockMemory& memory)
  {
    const std::uint32_t hash = hashOf(corner);
    VoxelBlock* block = findIn(newest(), corner, hash);
    return block ? *block : make(corner, hash, memory);
  }

  /** @brief The block with this corner, null if there is none. */
  VoxelBlock* find(const VoxelCode& corner, std::uint32_t hash) const
  {
    return findIn(newest(), corner, hash);
  }

  /** @brief Where the search for a block begins, to be prefetched. */
  const void* placeOf(std::uint32_t hash) const
  {
    const Table& table = newest();
    return &table.slots[hash & table.mask];
  }

  /** @brief The block where the search begins, null if there is none: most often the
   * one that is looked for. */
  const VoxelBlock* guess(std::uint32_t hash) const
  {
    const Table& table = newest();
    return table.at(hash & table.mask);
  }

  std::atomic<std::uint32_t> meetings{0}; ///< of threads that add to the same block

private:
  struct Table {
    explicit Table(std::size_t size)
        : mask(size - 1)
        , slots(new std::atomic<VoxelBlock*>[size]())
    {}

    VoxelBlock* at(std::size_t slot) const
    {
      return slots[slot].load(std::memory_order_acquire);
    }

    std::size_t mask; ///< one less than its size, a power of two
    std::unique_ptr<std::atomic<VoxelBlock*>[]> slots;
  };

  const Table& newest() const { return *newest_.load(std::memory_order_acquire); }

  /** @brief The slot of a block, or the empty one where it belongs, while none is made.
   */
  static std::size_t
  slotOf(const Table& table, const VoxelCode& corner, std::uint32_t hash)
  {
    std::size_t slot = hash & table.mask;
    for (const VoxelBlock* block = table.at(slot);
         block && !isSame(block->corner, corner); block = table.at(slot))
      slot = (slot + 1) & table.mask;
    return slot;
  }

  /** @brief Null if there is none. Each slot is read once: another thread may fill one
   * that was empty with a block that was not looked for. */
  static VoxelBlock*
  findIn(const Table& table, const VoxelCode& corner, std::uint32_t hash)
  {
    std::size_t slot = hash & table.mask;
    VoxelBlock* block = table.at(slot);
    while (block && !isSame(block->corner, corner)) {
      slot = (slot + 1) & table.mask;
      block = table.at(slot);
    }
    return block;
  }

  VoxelBlock& make(const VoxelCode& corner, std::uint32_t hash, BlockMemory& memory)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (2 * (size_ + 1) > tables_.back()->mask)
      grow();
    const Table& table = *tables_.back();
    auto& slot = table.slots[slotOf(table, corner, hash)];
    VoxelBlock* block = slot.load(std::memory_order_relaxed);
    if (block) // made by another thread in the meantime
      return *block;
    block = &memory.makeBlock(corner);
    slot.store(block, std::memory_order_release);
    ++size_;
    return *block;
  }

  void grow()
  {
    std::unique_ptr<Table> larger(new Table(2 * (tables_.back()->mask + 1)));
    forEach([&](VoxelBlock& block) {
      larger->slots[slotOf(*larger, block.corner, hashOf(block.corner))].store(
          &block, std::memory_order_relaxed);
    });
    tables_.push_back(std::move(larger));
    newest_.store(tables_.back().get(), std::memory_order_release);
  }

  std::mutex mutex_;
  std::vector<std::unique_ptr<Table>> tables_;
  std::atomic<const Table*> newest_{nullptr};
  std::size_t size_ = 0;
};

} // namespace sedr
} // namespace pcl
