// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "block_directory.h"

#include "voxel_sums.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief The voxels of blocks by z, then y, then x, without comparing any of them: the
 * blocks are sorted by digits; in a row of blocks along x, each of the 16 lines of
 * voxels has its first place, and what comes before a voxel on its line is counted by
 * bits. O(n); 64 bytes a block while they are sorted, then 32, and 144 a row. */
class VoxelOrder {
public:
  /** @brief Counts the voxels that hold `least_points` points or more. No point may be
   * added before all have been seen. */
  VoxelOrder(const BlockDirectory& blocks,
             std::uint32_t least_points,
             unsigned threads);

  /** @brief Voxels that were counted. */
  std::size_t size() const { return size_; }

  /** @brief The box of all voxels, counted or not; there must be one. */
  const VoxelBox& box() const { return box_; }

  /** @brief Shows each of them with its place, from several threads, in no order. */
  void forEach(unsigned threads, const VoxelSums::See& see) const;

private:
  static constexpr std::size_t lines = VoxelBlock::edge * VoxelBlock::edge;

  struct Entry {
    VoxelCode corner;
    const VoxelBlock* block;
    std::uint64_t counted; ///< a bit for each voxel, the lowest for the first
  };

  /** @brief Blocks that differ along x alone. */
  struct Row {
    std::size_t begin;
    std::size_t end;
    std::array<std::size_t, lines> places; ///< of the first voxel of each line
  };

  void findBox();

  void leaveOut(std::uint32_t least_points);

  void sortBlocks();

  void findRows();

  void countVoxels(unsigned threads);

  /** @brief Sends for blocks that will soon be shown. */
  void prefetchAfter(std::size_t i) const;

  void showBlock(const Entry& entry,
                 std::array<std::size_t, lines>& places,
                 const VoxelSums::See& see) const;

  std::vector<Entry> blocks_;
  std::vector<Row> rows_;
  VoxelBox box_;
  std::size_t size_ = 0;
};

} // namespace sedr
} // namespace pcl
