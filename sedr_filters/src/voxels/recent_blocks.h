// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "voxel_block.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace pcl::sedr {

/** @brief A cache of blocks by position. A new block replaces an earlier one at a
 * multiple of 16 blocks from it. */
class RecentBlocks {
public:
  /** @brief Returns the slot of the block with this corner. */
  static std::uint32_t slotOf(const VoxelCode& corner)
  {
    const auto digit = [&](std::size_t axis) {
      return static_cast<std::uint32_t>(corner[axis]) % window;
    };
    return digit(0) + window * (digit(1) + window * digit(2));
  }

  VoxelBlock*& at(std::size_t slot) { return blocks_[slot]; }

  /** @brief Returns the block with this corner, null if it is not cached. */
  VoxelBlock* find(std::size_t slot, const VoxelCode& corner) const
  {
    VoxelBlock* const block = blocks_[slot];
    return block && isSame(block->corner, corner) ? block : nullptr;
  }

private:
  static constexpr std::uint32_t window = 16;

  std::array<VoxelBlock*, std::size_t{window} * window * window> blocks_{};
};

} // namespace pcl::sedr
