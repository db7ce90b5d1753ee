// SPDX-License-Identifier: BSD-3-Clause
#include "voxel_order.h"

#include <pcl/sedr_filters/parallel.h>
#include <pcl/sedr_filters/voxel_sums.h>

#include <algorithm>
#include <utility>

namespace pcl {
namespace sedr {

namespace {

/** @brief Puts the codes of a voxel into one number that sorts as they do, of those
 * within a window of 2^21 voxels around most of them. */
class VoxelKeys {
public:
  static constexpr unsigned bits = 21;

  explicit VoxelKeys(const std::vector<VoxelSum>& sample)
  {
    std::vector<std::int32_t> codes;
    for (std::size_t axis = 0; axis < 3 && !sample.empty(); ++axis) {
      codes.clear();
      for (const VoxelSum& voxel : sample)
        codes.push_back(voxel.code[axis]);
      const auto middle =
          codes.begin() + static_cast<std::ptrdiff_t>(codes.size() / 2);
      std::nth_element(codes.begin(), middle, codes.end());
      low_[axis] = std::int64_t{*middle} - (std::int64_t{1} << (bits - 1));
    }
  }

  /** @brief Whether the window holds a voxel. */
  bool holds(const VoxelCode& code) const
  {
    return ((offset(code, 0) | offset(code, 1) | offset(code, 2)) >> bits) == 0;
  }

  /** @brief z, y and x side by side. */
  std::uint64_t of(const VoxelCode& code) const
  {
    return ((offset(code, 2) << bits) | offset(code, 1)) << bits | offset(code, 0);
  }

private:
  std::uint64_t offset(const VoxelCode& code, std::size_t axis) const
  {
    return static_cast<std::uint64_t>(code[axis] - low_[axis]);
  }

  std::array<std::int64_t, 3> low_{};
};

/** @brief A voxel by its key and where it stands. */
struct KeyedVoxel {
  std::uint64_t key;
  std::uint64_t place;
};

bool
hasLowerKey(const KeyedVoxel& a, const KeyedVoxel& b)
{
  return a.key < b.key;
}

/** @brief Parts the keys into many of about equal size, by those of a sample. */
class KeyParts {
public:
  static constexpr std::size_t count = 256;

  KeyParts(const std::vector<VoxelSum>& sample, const VoxelKeys& keys)
      : keys_(keys)
  {
    std::vector<std::uint64_t> sorted;
    for (const VoxelSum& voxel : sample)
      if (keys.holds(voxel.code))
        sorted.push_back(keys.of(voxel.code));
    std::sort(sorted.begin(), sorted.end());
    splitters_.fill(~std::uint64_t{0});
    for (std::size_t k = 1; k < count && !sorted.empty(); ++k)
      splitters_[k - 1] = sorted[k * sorted.size() / count];
  }

  /** @brief The part of a voxel; `count` for those that the window does not hold. */
  std::size_t of(const VoxelCode& code) const
  {
    if (!keys_.holds(code))
      return count;
    const std::uint64_t key = keys_.of(code);
    std::size_t part = 0;
    for (std::size_t step = count / 2; step > 0; step /= 2)
      part += splitters_[part + step - 1] <= key ? step : 0;
    return part;
  }

private:
  const VoxelKeys& keys_;
  std::array<std::uint64_t, count> splitters_{};
};

std::size_t
sizeOf(const VoxelTable* tables)
{
  std::size_t size = 0;
  for (std::size_t t = 0; t < VoxelTable::table_count; ++t)
    size += tables[t].size();
  return size;
}

/** @brief Every k-th voxel, about `size` of them. Their order is that of their hashes,
 * so that they are a random sample. */
std::vector<VoxelSum>
sampleOf(const VoxelTable* tables, std::size_t size)
{
  const std::size_t step = sizeOf(tables) / size + 1;
  std::vector<VoxelSum> sample;
  std::size_t seen = 0;
  for (std::size_t t = 0; t < VoxelTable::table_count; ++t)
    tables[t].forEach([&](const VoxelSum& voxel) {
      if (seen++ % step == 0)
        sample.push_back(voxel);
    });
  return sample;
}

/** @brief Sorts the voxels of one part. */
void
sortPart(VoxelSum* first, std::size_t size, const VoxelKeys& keys)
{
  std::vector<KeyedVoxel> keyed(size);
  for (std::size_t i = 0; i < size; ++i)
    keyed[i] = {keys.of(first[i].code), i};
  std::sort(keyed.begin(), keyed.end(), hasLowerKey);
  const std::vector<VoxelSum> voxels(first, first + size);
  for (std::size_t i = 0; i < size; ++i)
    first[i] = voxels[keyed[i].place];
}

} // namespace

std::vector<VoxelSum>
takeSorted(VoxelTable* tables, unsigned threads)
{
  constexpr std::size_t samples_a_part = 16;
  constexpr std::size_t parts_and_strays = KeyParts::count + 1;
  constexpr std::size_t few = 10000; // not worth waking threads
  const auto sample = sampleOf(tables, samples_a_part * KeyParts::count);
  if (sizeOf(tables) < few)
    threads = 1;
  const VoxelKeys keys(sample);
  const KeyParts parts(sample, keys);

  std::vector<std::array<std::size_t, parts_and_strays>> next(VoxelTable::table_count);
  parallelBlocks(next.size(), 1, threads, [&](std::size_t t, std::size_t) {
    next[t].fill(0);
    tables[t].forEach([&](const VoxelSum& v) { ++next[t][parts.of(v.code)]; });
  });
  std::vector<std::size_t> begin;
  std::size_t total = 0;
  for (std::size_t part = 0; part < parts_and_strays; ++part) {
    begin.push_back(total);
    for (auto& of_table : next)
      total += std::exchange(of_table[part], total);
  }
  std::vector<VoxelSum> voxels(total);
  parallelBlocks(next.size(), 1, threads, [&](std::size_t t, std::size_t) {
    tables[t].forEach(
        [&](const VoxelSum& v) { voxels[next[t][parts.of(v.code)]++] = v; });
    tables[t].release();
  });

  parallelBlocks(KeyParts::count, 1, threads, [&](std::size_t part, std::size_t) {
    sortPart(voxels.data() + begin[part], begin[part + 1] - begin[part], keys);
  });
  const auto strays =
      voxels.begin() + static_cast<std::ptrdiff_t>(begin[KeyParts::count]);
  std::sort(strays, voxels.end(), isBefore);
  std::inplace_merge(voxels.begin(), strays, voxels.end(), isBefore);
  return voxels;
}

} // namespace sedr
} // namespace pcl
