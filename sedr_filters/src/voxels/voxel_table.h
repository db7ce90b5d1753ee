// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "voxel_frame.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace pcl::sedr {

/** @brief Hashes the codes of a voxel; all bits can be used. */
inline std::uint64_t
hashOf(const VoxelCode& code)
{
  const auto widened = [](std::int32_t c) {
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(c));
  };
  std::uint64_t h = widened(code[0]) * 0x9e3779b97f4a7c15u +
                    widened(code[1]) * 0xc2b2ae3d27d4eb4fu +
                    widened(code[2]) * 0x165667b19e3779f9u;
  h ^= h >> 32;
  h *= 0xd6e8feb86659fd93u;
  return h ^ h >> 32;
}

/** @brief Checks whether two voxels are the same; faster than memcmp(). */
inline bool
isSame(const VoxelCode& a, const VoxelCode& b)
{
  return ((a[0] ^ b[0]) | (a[1] ^ b[1]) | (a[2] ^ b[2])) == 0;
}

/** @brief A hash table of the sums of voxels, which stay where they are. */
class VoxelTable {
public:
  /** @brief Prefetches memory that will soon be used. */
  static void prefetch(const void* where)
  {
#ifdef __GNUC__
    __builtin_prefetch(where, 1);
#else
    static_cast<void>(where);
#endif
  }

  /** @brief Adds a sum, whose count is not 0, to that of its voxel. */
  void add(const VoxelSum& sum, std::uint64_t hash)
  {
    if (2 * (size_ + 1) > slots_.size())
      grow();
    Slot& slot = slots_[find(sum.code, hash)];
    if (slot.number > 0) {
      at(slot.number - 1) += sum;
      return;
    }
    if (size_ % sums_a_page == 0)
      pages_.emplace_back(new VoxelSum[sums_a_page]); // not cleared
    slot = {static_cast<std::uint32_t>(hash), static_cast<std::uint32_t>(++size_)};
    at(size_ - 1) = sum;
  }

  /** @brief Prefetches the slot where add() will look. */
  void expectSlot(std::uint64_t hash) const
  {
    if (!slots_.empty())
      prefetch(&slots_[hash & (slots_.size() - 1)]);
  }

  /** @brief Prefetches the sum that add() will find. */
  void expectSum(std::uint64_t hash) const
  {
    if (slots_.empty())
      return;
    const Slot& slot = slots_[firstLike(hash, hash)];
    if (slot.number == 0)
      return;
    prefetch(&at(slot.number - 1));
    prefetch(&at(slot.number - 1).sum[2]); // perhaps in the next line of the cache
  }

  /** @brief Returns the number of voxels. */
  std::size_t size() const
  {
    return size_;
  }

  /** @brief Returns a sum by its number in the order of creation. */
  const VoxelSum& operator[](std::size_t number) const
  {
    return at(number);
  }

  /** @brief Returns the number of a voxel, -1 if there is none. */
  std::int64_t numberOf(const VoxelCode& code, std::uint64_t hash) const
  {
    return slots_.empty() ? -1 : std::int64_t{slots_[find(code, hash)].number} - 1;
  }

private:
  static constexpr std::size_t sums_a_page = 256;

  struct Slot {
    std::uint32_t hash = 0;   ///< its low bits
    std::uint32_t number = 0; ///< of the sum plus one; 0: empty
  };

  VoxelSum& at(std::size_t number) const
  {
    return pages_[number / sums_a_page][number % sums_a_page];
  }

  /** @brief Returns the first slot, from the one of `start` on, that is empty or has
   * the same hash. */
  std::size_t firstLike(std::uint64_t hash, std::uint64_t start) const
  {
    std::size_t s = start & (slots_.size() - 1);
    while (slots_[s].number > 0 && slots_[s].hash != static_cast<std::uint32_t>(hash))
      s = (s + 1) & (slots_.size() - 1);
    return s;
  }

  /** @brief Returns the slot of a voxel, or the empty one for it. */
  std::size_t find(const VoxelCode& code, std::uint64_t hash) const
  {
    std::size_t s = firstLike(hash, hash);
    while (slots_[s].number > 0 && !isSame(at(slots_[s].number - 1).code, code))
      s = firstLike(hash, s + 1);
    return s;
  }

  void grow()
  {
    constexpr std::size_t fewest = 16;
    std::vector<Slot> old(std::max(fewest, 2 * slots_.size()));
    old.swap(slots_);
    for (const Slot& slot : old) {
      if (slot.number == 0)
        continue;
      std::size_t s = slot.hash & (slots_.size() - 1);
      while (slots_[s].number > 0)
        s = (s + 1) & (slots_.size() - 1);
      slots_[s] = slot;
    }
  }

  std::vector<Slot> slots_; ///< at most half full, as many as a power of two
  std::vector<std::unique_ptr<VoxelSum[]>> pages_;
  std::size_t size_ = 0;
};

} // namespace pcl::sedr
