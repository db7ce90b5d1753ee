// SPDX-License-Identifier: BSD-3-Clause
#include "voxel_order.h"

#include "voxel_ranks.h"

#include <pcl/sedr_filters/parallel.h>
#include <pcl/sedr_filters/voxel_sums.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace pcl {
namespace sedr {

namespace {

std::size_t
sizeOf(const VoxelTable* tables)
{
  std::size_t size = 0;
  for (std::size_t t = 0; t < VoxelTable::table_count; ++t)
    size += tables[t].size();
  return size;
}

/** @brief About `size` of the voxels: of every k-th table slot, which is as good as
 * random, for the slots are in the order of hashes. */
std::vector<VoxelCode>
sampleOf(const VoxelTable* tables, std::size_t size)
{
  const std::size_t step = sizeOf(tables) / size + 1;
  std::vector<VoxelCode> sample;
  std::size_t seen = 0;
  for (std::size_t t = 0; t < VoxelTable::table_count; ++t)
    tables[t].forEach([&](const VoxelSum& voxel) {
      if (seen++ % step == 0)
        sample.push_back(voxel.code);
    });
  return sample;
}

/** @brief A box around nearly all voxels: that of all but the outermost hundredth of a
 * sample at each end, and half as much again. */
VoxelBox
boxAroundMost(const std::vector<VoxelCode>& sample)
{
  constexpr std::int64_t margin = 64;
  VoxelBox box;
  std::vector<std::int64_t> codes;
  for (std::size_t axis = 0; axis < 3 && !sample.empty(); ++axis) {
    codes.clear();
    for (const VoxelCode& code : sample)
      codes.push_back(code[axis]);
    std::sort(codes.begin(), codes.end());
    const std::size_t cut = codes.size() / 100;
    const std::int64_t low = codes[cut];
    const std::int64_t high = codes[codes.size() - 1 - cut];
    box.low[axis] = low - (high - low) / 2 - margin;
    box.high[axis] = high + (high - low) / 2 + margin;
  }
  return box;
}

/** @brief The smallest box of the voxels that `most` holds, and how many it does not
 * hold. */
std::pair<VoxelBox, std::size_t>
tightBox(const VoxelTable* tables, const VoxelBox& most, unsigned threads)
{
  constexpr std::int64_t limit = std::numeric_limits<std::int64_t>::max();
  struct Part {
    VoxelBox box{{limit, limit, limit}, {-limit, -limit, -limit}};
    std::size_t strays = 0;
  };
  std::vector<Part> parts(VoxelTable::table_count);
  const auto widen = [](VoxelBox& box, const auto& low, const auto& high) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.low[axis] = std::min<std::int64_t>(box.low[axis], low[axis]);
      box.high[axis] = std::max<std::int64_t>(box.high[axis], high[axis]);
    }
  };
  parallelBlocks(parts.size(), 1, threads, [&](std::size_t t, std::size_t) {
    tables[t].forEach([&](const VoxelSum& voxel) {
      if (most.holds(voxel.code))
        widen(parts[t].box, voxel.code, voxel.code);
      else
        ++parts[t].strays;
    });
  });
  for (std::size_t t = 1; t < parts.size(); ++t) {
    widen(parts[0].box, parts[t].box.low, parts[t].box.high);
    parts[0].strays += parts[t].strays;
  }
  return {parts[0].box, parts[0].strays};
}

/** @brief Sorts by comparing: each half by itself, and so on, then merges them. */
void
sortHalves(VoxelSum* first, VoxelSum* last, unsigned threads)
{
  if (threads < 2) {
    std::sort(first, last, isBefore);
    return;
  }
  VoxelSum* const middle = first + (last - first) / 2;
  parallelBlocks(2, 1, 2, [&](std::size_t half, std::size_t) {
    std::sort(half == 0 ? first : middle, half == 0 ? middle : last, isBefore);
  });
  std::inplace_merge(first, middle, last, isBefore);
}

} // namespace

std::vector<VoxelSum>
takeSorted(VoxelTable* tables, unsigned threads)
{
  constexpr std::size_t few = 10000; // not worth waking threads
  constexpr std::size_t sample_size = 4096;
  constexpr double bits_a_voxel = 256;
  threads = sizeOf(tables) < few ? 1 : resolveThreads(threads);
  auto [box, strays] =
      tightBox(tables, boxAroundMost(sampleOf(tables, sample_size)), threads);
  std::vector<VoxelSum> voxels(sizeOf(tables));
  std::size_t inside = voxels.size() - strays;
  // Voxels all far from one another are not worth a bit for each between them.
  if (inside == 0 ||
      box.volume() > bits_a_voxel * static_cast<double>(voxels.size()) + few) {
    inside = 0;
    box = {{1, 1, 1}, {0, 0, 0}};
  }
  VoxelRanks ranks(inside > 0 ? box : VoxelBox());
  if (inside > 0) {
    parallelBlocks(VoxelTable::table_count, 1, threads,
                   [&](std::size_t t, std::size_t) {
                     tables[t].forEach([&](const VoxelSum& voxel) {
                       if (box.holds(voxel.code))
                         ranks.mark(voxel.code);
                     });
                   });
    ranks.number();
  }
  std::atomic<std::size_t> next_outside{inside};
  parallelBlocks(VoxelTable::table_count, 1, threads, [&](std::size_t t, std::size_t) {
    tables[t].forEach([&](const VoxelSum& voxel) {
      voxels[box.holds(voxel.code) ? ranks.rankOf(voxel.code) : next_outside++] = voxel;
    });
    tables[t].release();
  });
  VoxelSum* const middle = voxels.data() + inside;
  sortHalves(middle, voxels.data() + voxels.size(), threads);
  std::inplace_merge(voxels.data(), middle, voxels.data() + voxels.size(), isBefore);
  return voxels;
}

} // namespace sedr
} // namespace pcl
