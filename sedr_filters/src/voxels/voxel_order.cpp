// SPDX-License-Identifier: BSD-3-Clause
#include "voxel_order.h"

#include "../base/parallel.h"

#include <algorithm>

namespace pcl::sedr {

namespace {

constexpr unsigned edge = VoxelBlock::edge;
constexpr std::size_t rows_at_once = 4;

/** @brief Bits of the first layer of voxels of a block along each axis. */
constexpr std::array<std::uint64_t, 3> first_layer{0x1111111111111111u,
                                                   0x000f000f000f000fu, 0xffffu};
constexpr std::array<unsigned, 3> layer_bits{1, edge, edge* edge};

/** @brief Returns how many of four bits are set. */
unsigned
countOf(unsigned bits)
{
  bits = (bits & 5u) + (bits >> 1 & 5u);
  return (bits & 3u) + (bits >> 2);
}

/** @brief Returns the bits of the voxels on a line along x. */
unsigned
lineOf(std::uint64_t voxels, std::size_t line)
{
  return static_cast<unsigned>(voxels >> edge * line) & ((1u << edge) - 1);
}

/** @brief Returns the number of threads: 1 for few blocks, to wake no others. */
unsigned
threadsFor(std::size_t blocks, unsigned threads)
{
  constexpr std::size_t few = 500;
  return blocks < few ? 1 : threads;
}

} // namespace

VoxelOrder::VoxelOrder(const BlockDirectory& blocks,
                       std::uint32_t min_points,
                       unsigned threads)
{
  blocks_.reserve(blocks.size());
  blocks.forEach([&](VoxelBlock& block) {
    blocks_.push_back({block.corner, &block, block.occupied});
  });
  if (blocks_.empty())
    return;
  findBox();
  if (min_points > 1)
    leaveOut(min_points);
  sortBlocks();
  findRows();
  countVoxels(threads);
}

void
VoxelOrder::findBox()
{
  box_.low = box_.high =
      blocks_[0].block->codeOf(blocks_[0].block->sums.load()[0].local);
  for (const Entry& entry : blocks_)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto low = static_cast<std::int32_t>(edge) * entry.corner[axis];
      const auto high = low + static_cast<std::int32_t>(edge) - 1;
      if (low >= box_.low[axis] && high <= box_.high[axis])
        continue;
      for (unsigned layer = 0; layer < edge; ++layer)
        if (entry.counted & first_layer[axis] << layer * layer_bits[axis]) {
          const auto code = low + static_cast<std::int32_t>(layer);
          box_.low[axis] = std::min(box_.low[axis], code);
          box_.high[axis] = std::max(box_.high[axis], code);
        }
    }
}

void
VoxelOrder::leaveOut(std::uint32_t min_points)
{
  for (Entry& entry : blocks_) {
    const BlockSum* const sums = entry.block->sums.load(std::memory_order_relaxed);
    for (std::size_t s = 0; s < entry.block->size; ++s)
      if (sums[s].count < min_points)
        entry.counted &= ~(std::uint64_t{1} << sums[s].local);
  }
}

/** Radix sort by the bytes of the corners relative to the box, from the last byte of x
 * to the first of z; skips bytes that all blocks share. */
void
VoxelOrder::sortBlocks()
{
  constexpr unsigned byte = 8;
  const VoxelCode low = VoxelBlock::cornerOf(box_.low);
  const VoxelCode high = VoxelBlock::cornerOf(box_.high);
  std::vector<Entry> sorted(blocks_.size());
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto from_low = [&](std::int32_t corner) {
      return static_cast<std::uint32_t>(corner) - static_cast<std::uint32_t>(low[axis]);
    };
    for (unsigned shift = 0; shift < 4 * byte && from_low(high[axis]) >> shift > 0;
         shift += byte) {
      const auto digitOf = [&](const Entry& entry) {
        return (from_low(entry.corner[axis]) >> shift) % (1u << byte);
      };
      std::array<std::size_t, (1u << byte) + 1> places{};
      for (const Entry& entry : blocks_)
        ++places[digitOf(entry) + 1];
      for (std::size_t digit = 1; digit < places.size(); ++digit)
        places[digit] += places[digit - 1];
      for (const Entry& entry : blocks_)
        sorted[places[digitOf(entry)]++] = entry;
      blocks_.swap(sorted);
    }
  }
}

void
VoxelOrder::findRows()
{
  const auto begins = [&](std::size_t i) {
    return i == 0 || blocks_[i].corner[1] != blocks_[i - 1].corner[1] ||
           blocks_[i].corner[2] != blocks_[i - 1].corner[2];
  };
  std::size_t count = 0; // counted first, so that the large entries are not moved
  for (std::size_t i = 0; i < blocks_.size(); ++i)
    count += begins(i) ? 1 : 0;
  rows_.reserve(count);
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    if (begins(i))
      rows_.push_back({i, i, {}});
    ++rows_.back().end;
  }
}

void
VoxelOrder::countVoxels(unsigned threads)
{
  parallelBlocks(rows_.size(), rows_at_once, threadsFor(blocks_.size(), threads),
                 [&](std::size_t begin, std::size_t end) {
                   for (std::size_t r = begin; r < end; ++r)
                     for (std::size_t i = rows_[r].begin; i < rows_[r].end; ++i) {
                       const std::uint64_t voxels = blocks_[i].counted;
                       for (std::size_t line = 0; line < lines; ++line)
                         rows_[r].places[line] += countOf(lineOf(voxels, line));
                     }
                 });
  const auto zOf = [&](std::size_t row) { return blocks_[rows_[row].begin].corner[2]; };
  for (std::size_t begin = 0, end = 0; begin < rows_.size(); begin = end) {
    while (end < rows_.size() && zOf(end) == zOf(begin))
      ++end;
    for (std::size_t z = 0; z < edge; ++z)
      for (std::size_t r = begin; r < end; ++r)
        for (std::size_t y = 0; y < edge; ++y) {
          std::size_t& place = rows_[r].places[edge * z + y];
          const std::size_t count = place;
          place = size_;
          size_ += count;
        }
  }
}

void
VoxelOrder::forEach(unsigned threads, const VoxelSums::See& see) const
{
  parallelBlocks(rows_.size(), rows_at_once, threadsFor(blocks_.size(), threads),
                 [&](std::size_t begin, std::size_t end) {
                   for (std::size_t r = begin; r < end; ++r) {
                     auto places = rows_[r].places;
                     for (std::size_t i = rows_[r].begin; i < rows_[r].end; ++i) {
                       prefetchAfter(i);
                       showBlock(blocks_[i], places, see);
                     }
                   }
                 });
}

void
VoxelOrder::prefetchAfter(std::size_t i) const
{
  constexpr std::size_t block_ahead = 8;
  constexpr std::size_t sums_ahead = 3;
  constexpr std::size_t sums_a_line = 2;
  if (i + block_ahead < blocks_.size())
    prefetch(blocks_[i + block_ahead].block);
  if (i + sums_ahead >= blocks_.size())
    return;
  const VoxelBlock& block = *blocks_[i + sums_ahead].block;
  const BlockSum* const sums = block.sums.load(std::memory_order_relaxed);
  for (std::size_t s = 0; s < block.size; s += sums_a_line)
    prefetch(sums + s);
}

void
VoxelOrder::showBlock(const Entry& entry,
                      std::array<std::size_t, lines>& places,
                      const VoxelSums::See& see) const
{
  std::array<VoxelSum, VoxelBlock::volume> voxels;
  std::array<std::size_t, VoxelBlock::volume> places_of_voxels;
  const VoxelBlock& block = *entry.block;
  const std::uint64_t counted = entry.counted;
  const BlockSum* const sums = block.sums.load(std::memory_order_relaxed);
  std::size_t n = 0;
  for (std::size_t s = 0; s < block.size; ++s) {
    const BlockSum& sum = sums[s];
    if ((counted >> sum.local & 1) == 0)
      continue;
    const std::size_t line = sum.local / edge;
    const unsigned before = lineOf(counted, line) & ((1u << sum.local % edge) - 1);
    places_of_voxels[n] = places[line] + countOf(before);
    voxels[n] = {block.codeOf(sum.local), sum.count, sum.steps};
    ++n;
  }
  see(voxels.data(), places_of_voxels.data(), n);
  for (std::size_t line = 0; line < lines; ++line)
    places[line] += countOf(lineOf(counted, line));
}

} // namespace pcl::sedr
