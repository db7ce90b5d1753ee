// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "block_memory.h"

#include "voxel_hash.h"

#include <atomic>
#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

namespace pcl::sedr {

/** @brief A hash table of blocks by their corner, at most half full, shared by all
 * threads. Lookups never wait; insertions are made one at a time. An outgrown table is
 * kept until the end, because other threads may still read it. */
class BlockDirectory {
public:
  BlockDirectory()
  {
    tables_.emplace_back(new Table(1024));
    newest_ = tables_.back().get();
  }

  /** @brief Returns the number of blocks; not during insertions. */
  std::size_t size() const { return size_; }

  /** @brief Calls `see` for all blocks; not during insertions. */
  template <typename See>
  void forEach(const See& see) const
  {
    const Table& table = *tables_.back();
    for (std::size_t slot = 0; slot <= table.mask; ++slot)
      if (VoxelBlock* const block = table.at(slot))
        see(*block);
  }

  /** @brief Returns the block with this corner, created in `memory` if needed. */
  VoxelBlock& find(const VoxelCode& corner, BlockMemory& memory)
  {
    const std::uint32_t hash = hashOf(corner);
    VoxelBlock* block = findIn(newest(), corner, hash);
    return block ? *block : make(corner, hash, memory);
  }

  /** @brief Returns the block with this corner, null if there is none. */
  VoxelBlock* find(const VoxelCode& corner, std::uint32_t hash) const
  {
    return findIn(newest(), corner, hash);
  }

  /** @brief Returns the address where the search begins, for prefetching. */
  const void* placeOf(std::uint32_t hash) const
  {
    const Table& table = newest();
    return &table.slots[hash & table.mask];
  }

  /** @brief Returns the block at which the search begins, null if there is none:
   * usually the one sought. */
  const VoxelBlock* guess(std::uint32_t hash) const
  {
    const Table& table = newest();
    return table.at(hash & table.mask);
  }

  std::atomic<std::uint32_t> meetings{0}; ///< times that threads met

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

    std::size_t mask; ///< table size - 1; the size is a power of two
    std::unique_ptr<std::atomic<VoxelBlock*>[]> slots;
  };

  const Table& newest() const { return *newest_.load(std::memory_order_acquire); }

  /** @brief Returns the slot of a block, or the empty slot where it belongs; not during
   * insertions. */
  static std::size_t
  slotOf(const Table& table, const VoxelCode& corner, std::uint32_t hash)
  {
    std::size_t slot = hash & table.mask;
    for (const VoxelBlock* block = table.at(slot);
         block && !isSame(block->corner, corner); block = table.at(slot))
      slot = (slot + 1) & table.mask;
    return slot;
  }

  /** @brief Returns a block, null if there is none. Each slot is read only once,
   * because another thread may fill an empty slot with a different block. */
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

} // namespace pcl::sedr
