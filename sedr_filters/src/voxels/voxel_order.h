// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "block_directory.h"

#include "voxel_sums.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief The order of the voxels of all blocks by z, then y, then x, found without
 * comparisons. The blocks are radix sorted. For each row of blocks along x, the output
 * positions of its 16 lines of voxels are stored; the position on a line comes from a
 * bit count. O(n); 64 bytes a block while sorting, then 32, and 144 a row. */
class VoxelOrder {
public:
  /** @brief Counts the voxels with at least `min_points` points. Until the last
   * forEach(), no point may be added. */
  VoxelOrder(const BlockDirectory& blocks, std::uint32_t min_points, unsigned threads);

  /** @brief Returns the number of counted voxels. */
  std::size_t size() const { return size_; }

  /** @brief Returns the box of all voxels, counted or not; there must be one. */
  const VoxelBox& box() const { return box_; }

  /** @brief Calls `see` for each counted voxel, from several threads in any order. */
  void forEach(unsigned threads, const VoxelSums::See& see) const;

private:
  static constexpr std::size_t lines = VoxelBlock::edge * VoxelBlock::edge;

  struct Entry {
    VoxelCode corner;
    const VoxelBlock* block;
    std::uint64_t counted; ///< one bit for each voxel, the lowest for the first
  };

  /** @brief Blocks that differ only in x. */
  struct Row {
    std::size_t begin;
    std::size_t end;
    std::array<std::size_t, lines> places; ///< position of the first voxel of each line
  };

  void findBox();

  void leaveOut(std::uint32_t min_points);

  void sortBlocks();

  void findRows();

  void countVoxels(unsigned threads);

  /** @brief Prefetches blocks that will soon be visited. */
  void prefetchAfter(std::size_t i) const;

  void showBlock(const Entry& entry,
                 std::array<std::size_t, lines>& places,
                 const VoxelSums::See& see) const;

  std::vector<Entry> blocks_;
  std::vector<Row> rows_;
  VoxelBox box_;
  std::size_t size_ = 0;
};

} // namespace pcl::sedr
