// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "voxel_hash.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace pcl::sedr {

/** @brief Prefetches memory that will soon be used. */
inline void
prefetch(const void* where)
{
#ifdef __GNUC__
  __builtin_prefetch(where, 1);
#else
  static_cast<void>(where);
#endif
}

/** @brief A lock for a few instructions; usually nobody else wants it. */
class SpinLock {
public:
  void lock()
  {
    while (locked_.exchange(true, std::memory_order_acquire))
      std::this_thread::yield();
  }

  void unlock() { locked_.store(false, std::memory_order_release); }

private:
  std::atomic<bool> locked_{false};
};

/** @brief A cube of 4 x 4 x 4 voxels and the sums of its occupied voxels, in order of
 * creation. Surfaces fill a quarter of it or more, and consecutive points of a scanner
 * mostly lie in one or two. */
struct VoxelBlock {
  static constexpr unsigned edge_bits = 2;
  static constexpr unsigned edge = 1u << edge_bits; ///< voxels
  static constexpr unsigned volume = edge * edge * edge;

  /** @brief Returns the block of a voxel. */
  static VoxelCode cornerOf(const VoxelCode& code)
  {
    return {code[0] >> edge_bits, code[1] >> edge_bits, code[2] >> edge_bits};
  }

  /** @brief Returns the number of a voxel in its block: by z, then y, then x. */
  static unsigned localOf(const VoxelCode& code)
  {
    const auto digit = [&](std::size_t axis) {
      return static_cast<std::uint32_t>(code[axis]) % edge;
    };
    return digit(0) + edge * (digit(1) + edge * digit(2));
  }

  explicit VoxelBlock(const VoxelCode& corner_of_it)
      : corner(corner_of_it)
  {}

  /** @brief Returns the sum of a voxel, which is created if needed. */
  VoxelSum& at(const VoxelCode& code)
  {
    std::uint8_t& place = places[localOf(code)];
    if (place == 0) {
      constexpr std::size_t fewest = 8;
      if (sums.size() == sums.capacity())
        sums.reserve(std::max(fewest, 2 * sums.size()));
      sums.push_back({code, 0, {}});
      place = static_cast<std::uint8_t>(sums.size());
      occupied |= std::uint64_t{1} << localOf(code);
    }
    return sums[place - 1u];
  }

  std::vector<VoxelSum> sums;
  VoxelCode corner;
  SpinLock lock;
  std::uint64_t occupied = 0;                ///< a bit for each voxel
  std::array<std::uint8_t, volume> places{}; ///< in `sums`, plus one; 0: none
};

/** @brief The blocks of all points, shared by all threads. A hash of its corner deals a
 * block to one of the shards, each of which is a hash table with a lock. */
class VoxelBlocks {
public:
  /** @brief Returns a block, which is created if needed. It stays where it is. */
  VoxelBlock& at(const VoxelCode& corner, std::uint64_t hash)
  {
    Shard& shard = shardOf(hash);
    const std::lock_guard<SpinLock> lock(shard.lock);
    return shard.at(corner, hash);
  }

  /** @brief Prefetches where at() will look. */
  void expect(std::uint64_t hash)
  {
    Shard& shard = shardOf(hash);
    const std::lock_guard<SpinLock> lock(shard.lock);
    if (!shard.slots.empty())
      prefetch(&shard.slots[shard.first(hash)]);
  }

  /** @brief Calls `see` for all blocks; not during insertions. */
  template <typename See>
  void forEach(const See& see) const
  {
    for (const Shard& shard : *shards_)
      for (const VoxelBlock& block : shard.blocks)
        see(block);
  }

private:
  struct Slot {
    VoxelCode corner;
    std::uint32_t number; ///< of the block, plus one; 0: empty
  };

  struct alignas(64) Shard {
    std::size_t first(std::uint64_t hash) const { return hash & (slots.size() - 1); }

    Slot& find(const VoxelCode& corner, std::uint64_t hash)
    {
      std::size_t slot = first(hash);
      while (slots[slot].number != 0 && !isSame(slots[slot].corner, corner))
        slot = (slot + 1) & (slots.size() - 1);
      return slots[slot];
    }

    VoxelBlock& at(const VoxelCode& corner, std::uint64_t hash)
    {
      if (2 * (blocks.size() + 1) > slots.size())
        grow();
      Slot& slot = find(corner, hash);
      if (slot.number == 0) {
        blocks.emplace_back(corner);
        slot = {corner, static_cast<std::uint32_t>(blocks.size())};
      }
      return blocks[slot.number - 1];
    }

    void grow()
    {
      constexpr std::size_t fewest = 16;
      slots.assign(std::max(fewest, 2 * slots.size()), {});
      for (std::size_t b = 0; b < blocks.size(); ++b)
        find(blocks[b].corner, hashOf(blocks[b].corner)) = {
            blocks[b].corner, static_cast<std::uint32_t>(b + 1)};
    }

    SpinLock lock;
    std::vector<Slot> slots; ///< at most half full, a power of two
    std::deque<VoxelBlock> blocks;
  };

  static constexpr std::size_t shard_count = 64;

  Shard& shardOf(std::uint64_t hash) const { return (*shards_)[hash >> 58]; }

  using Shards = std::array<Shard, shard_count>;

  std::unique_ptr<Shards> shards_{new Shards};
};

} // namespace pcl::sedr
