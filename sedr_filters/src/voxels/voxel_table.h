// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "voxel_frame.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <utility>
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

/** @brief A hash table of the sums of voxels, numbered as they came; they stay where
 * they are. */
class VoxelTable {
public:
  /** @brief Adds a sum to that of its voxel. */
  void add(const VoxelSum& sum)
  {
    if (2 * (sums_.size() + 1) > slots_.size())
      grow();
    Slot& slot = slots_[slotOf(sum.code)];
    if (slot.number > 0) {
      sums_[slot.number - 1] += sum;
      return;
    }
    sums_.push_back(sum);
    slot = {static_cast<std::uint32_t>(hashOf(sum.code)),
            static_cast<std::uint32_t>(sums_.size())};
  }

  /** @brief Returns the number of voxels. */
  std::size_t size() const { return sums_.size(); }

  const VoxelSum& operator[](std::size_t number) const { return sums_[number]; }

  /** @brief Sets the count of a voxel to 0.
   * @return what it was */
  std::uint32_t drop(std::size_t number)
  {
    return std::exchange(sums_[number].count, 0);
  }

  /** @brief Returns the number of a voxel, -1 if there is none. */
  std::int64_t numberOf(const VoxelCode& code) const
  {
    return slots_.empty() ? -1 : std::int64_t{slots_[slotOf(code)].number} - 1;
  }

private:
  struct Slot {
    std::uint32_t hash = 0;   ///< its low bits
    std::uint32_t number = 0; ///< of the sum plus one; 0: empty
  };

  /** @brief Returns the slot of a voxel, or the empty one for it. */
  std::size_t slotOf(const VoxelCode& code) const
  {
    const std::uint64_t hash = hashOf(code);
    std::size_t s = hash & (slots_.size() - 1);
    while (slots_[s].number > 0 &&
           (slots_[s].hash != static_cast<std::uint32_t>(hash) ||
            !isSame(sums_[slots_[s].number - 1].code, code)))
      s = (s + 1) & (slots_.size() - 1);
    return s;
  }

  void grow()
  {
    constexpr std::size_t fewest = 16;
    slots_.assign(std::max(fewest, 2 * slots_.size()), {});
    for (std::size_t k = 0; k < sums_.size(); ++k)
      slots_[slotOf(sums_[k].code)] = {
          static_cast<std::uint32_t>(hashOf(sums_[k].code)),
          static_cast<std::uint32_t>(k + 1)};
  }

  std::vector<Slot> slots_; ///< at most half full, as many as a power of two
  std::deque<VoxelSum> sums_;
};

} // namespace pcl::sedr
