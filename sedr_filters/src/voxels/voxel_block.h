// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "voxel_frame.h"
#include "voxel_hash.h"

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <thread>

namespace pcl::sedr {

/** @brief Prefetches memory that will soon be written. */
inline void
prefetch(const void* where)
{
#ifdef __GNUC__
  __builtin_prefetch(where, 1);
#else
  static_cast<void>(where);
#endif
}

/** @brief The sum of the points of a voxel and its place in its block. */
struct BlockSum {
  std::array<std::uint64_t, 3> steps; ///< along x, y and z, modulo 2^64
  std::uint32_t count;                ///< number of points
  std::uint32_t local;                ///< VoxelBlock::localOf() of the voxel
};

/** @brief A cube of 4 x 4 x 4 voxels and the sums of its occupied voxels, in order of
 * creation. Surfaces fill at least a quarter of it, so a sum takes little more than its
 * 32 bytes. Consecutive points of a scanner mostly lie in one block. It must be locked
 * for additions. */
struct alignas(32) VoxelBlock {
  static constexpr unsigned edge_bits = 2;
  static constexpr unsigned edge = 1u << edge_bits; ///< voxels
  static constexpr unsigned volume = edge * edge * edge;

  /** @brief Returns the corner of the block of a voxel, in blocks. */
  static VoxelCode cornerOf(const VoxelCode& code)
  {
    return {code[0] >> edge_bits, code[1] >> edge_bits, code[2] >> edge_bits};
  }

  /** @brief Returns the place of a voxel in its block: by z, then y, then x. */
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

  VoxelCode codeOf(unsigned local) const
  {
    const auto along = [&](std::size_t axis, unsigned digit) {
      return static_cast<std::int32_t>(edge) * corner[axis] +
             static_cast<std::int32_t>(digit);
    };
    return {along(0, local % edge), along(1, local / edge % edge),
            along(2, local / (edge * edge))};
  }

  bool tryLock() { return !locked.exchange(true, std::memory_order_acquire); }

  void lock()
  {
    while (!tryLock())
      std::this_thread::yield();
  }

  void unlock() { locked.store(false, std::memory_order_release); }

  /** @brief Returns the place of a voxel's sum plus one; 0 if it has none yet. */
  unsigned placeOf(unsigned local) const
  {
    return places[local].load(std::memory_order_relaxed);
  }

  VoxelCode corner;
  std::atomic<bool> locked{false};
  std::uint8_t size = 0;       ///< number of occupied voxels
  std::uint8_t room_class = 0; ///< capacity class of the storage, see BlockMemory
  /// One bit for each voxel, the lowest for the first: whether it is occupied.
  std::uint64_t occupied = 0;
  /// Another thread may read these two without the lock, to guess what to prefetch.
  std::atomic<BlockSum*> sums{nullptr};
  std::array<std::atomic<std::uint8_t>, volume> places{};
};

} // namespace pcl::sedr
