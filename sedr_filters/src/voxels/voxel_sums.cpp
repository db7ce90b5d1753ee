// SPDX-License-Identifier: BSD-3-Clause
#include "voxel_sums.h"

#include "../base/parallel.h"
#include "../base/parallel_for.h"
#include "../grids/digit_sort.h"
#include "voxel_census.h"
#include "voxel_table.h"

#include <algorithm>
#include <array>
#include <limits>
#include <mutex>

namespace pcl::sedr {

/** @brief The voxels of some hashes, and a lock for threads that add to them. */
struct alignas(64) VoxelSums::Shard {
  static constexpr std::size_t most_at_once = 64;

  VoxelTable table;
  std::vector<std::uint32_t> places; ///< of each voxel in the order plus one; 0: none
  std::mutex mutex;

  void add(const VoxelSum* sums, std::size_t n)
  {
    const std::lock_guard<std::mutex> lock(mutex);
    for (std::size_t i = 0; i < n; ++i)
      table.add(sums[i]);
  }
};

/** @brief The sums of a thread: a table with one slot for each hash, from which a voxel
 * moves to the shards when another needs its slot. In the order of a scan nearly all
 * points meet their voxel there. */
class VoxelSums::NearSums {
public:
  explicit NearSums(Shard* shards)
      : shards_(shards)
      , slots_(slot_count)
      , leaving_(shard_count * Shard::most_at_once)
  {}

  ~NearSums()
  {
    for (const VoxelSum& slot : slots_)
      if (slot.count > 0)
        leave(slot);
    for (std::size_t shard = 0; shard < shard_count; ++shard)
      flush(shard);
  }

  void add(const VoxelSum& sum)
  {
    VoxelSum& slot = slots_[hashOf(sum.code) >> 40 & (slot_count - 1)];
    if (slot.count > 0 && isSame(slot.code, sum.code)) {
      slot += sum;
      return;
    }
    if (slot.count > 0)
      leave(slot);
    slot = sum;
  }

private:
  static constexpr std::size_t slot_count = 4096; // 160 kB

  void leave(const VoxelSum& sum)
  {
    const std::size_t shard = shardOf(sum.code);
    leaving_[shard * Shard::most_at_once + counts_[shard]++] = sum;
    if (counts_[shard] == Shard::most_at_once)
      flush(shard);
  }

  void flush(std::size_t shard)
  {
    shards_[shard].add(&leaving_[shard * Shard::most_at_once], counts_[shard]);
    counts_[shard] = 0;
  }

  Shard* shards_;
  std::vector<VoxelSum> slots_;
  std::vector<VoxelSum> leaving_; ///< for each shard
  std::array<std::size_t, shard_count> counts_{};
};

VoxelSums::VoxelSums(const Eigen::Array3f& inverse_leaf)
    : frame_(inverse_leaf)
    , shards_(new Shard[shard_count])
{}

VoxelSums::~VoxelSums() = default;

std::size_t
VoxelSums::shardOf(const VoxelCode& code)
{
  constexpr int bits = 3; // voxels near each other are then near in memory, too
  return hashOf({code[0] >> bits, code[1] >> bits, code[2] >> bits}) >> 58;
}

void
VoxelSums::add(const PointView& points,
               unsigned threads,
               const pcl::Indices* indices,
               const RowSource::SeeRun& beside)
{
  constexpr std::size_t points_a_block = std::size_t{1} << 18;
  constexpr std::size_t points_a_run = std::size_t{1} << 14; // stay in the cache
  const std::size_t n = indices ? indices->size() : points.size();
  parallelBlocks(n, points_a_block, threads, [&](std::size_t begin, std::size_t end) {
    NearSums sums(shards_.get());
    for (; begin < end; begin += points_a_run) {
      const std::size_t run_end = std::min(begin + points_a_run, end);
      if (beside)
        beside(begin, run_end);
      for (std::size_t k = begin; k < run_end; ++k) {
        const Eigen::Vector3f point =
            points[indices ? static_cast<std::size_t>((*indices)[k]) : k];
        if (frame_.holds(point))
          sums.add(frame_.sumOf(point));
      }
    }
  });
}

void
VoxelSums::add(const std::vector<VoxelSum>& sums)
{
  for (const VoxelSum& sum : sums)
    if (sum.count > 0)
      shards_[shardOf(sum.code)].table.add(sum);
}

std::size_t
VoxelSums::size() const
{
  std::size_t size = 0;
  for (std::size_t s = 0; s < shard_count; ++s)
    size += shards_[s].table.size();
  return size;
}

std::uint32_t
VoxelSums::strayLimit() const
{
  VoxelCensus census;
  for (std::size_t s = 0; s < shard_count; ++s)
    for (std::size_t v = 0; v < shards_[s].table.size(); ++v)
      census.add(shards_[s].table[v].code, shards_[s].table[v].count);
  return census.minPoints();
}

std::size_t
VoxelSums::arrange(std::uint32_t min_points, unsigned threads)
{
  struct Entry {
    VoxelCode code;
    const VoxelSum* sum;
  };
  std::array<std::size_t, shard_count + 1> begins{};
  for (std::size_t s = 0; s < shard_count; ++s) {
    const VoxelTable& table = shards_[s].table;
    std::size_t kept = table.size();
    for (std::size_t v = 0; min_points > 1 && v < table.size(); ++v)
      kept -= table[v].count < min_points ? 1 : 0;
    begins[s + 1] = begins[s] + kept;
  }
  std::vector<Entry> entries(begins.back());
  parallelFor(shard_count, 1, threads, [&](std::size_t s) {
    Entry* next = entries.data() + begins[s];
    for (std::size_t v = 0; v < shards_[s].table.size(); ++v)
      if (const VoxelSum& sum = shards_[s].table[v]; sum.count >= min_points)
        *next++ = {sum.code, &sum};
  });
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::int32_t low = std::numeric_limits<std::int32_t>::max();
    for (const Entry& entry : entries)
      low = std::min(low, entry.code[axis]);
    sortByDigits(entries, [axis, low](const Entry& entry) {
      return static_cast<std::uint32_t>(entry.code[axis] - low);
    });
  }
  order_.resize(entries.size());
  std::transform(entries.begin(), entries.end(), order_.begin(),
                 [](const Entry& entry) { return entry.sum; });
  return order_.size();
}

std::vector<VoxelSum>
VoxelSums::take(unsigned threads)
{
  arrange(0, threads);
  std::vector<VoxelSum> taken;
  taken.reserve(order_.size());
  for (const VoxelSum* sum : order_)
    taken.push_back(*sum);
  order_.clear();
  shards_.reset(new Shard[shard_count]);
  return taken;
}

void
VoxelSums::forEach(const std::function<void(const VoxelSum&, std::size_t)>& see,
                   unsigned threads) const
{
  constexpr std::size_t voxels_a_block = 4096;
  parallelFor(order_.size(), voxels_a_block, threads,
              [&](std::size_t i) { see(*order_[i], i); });
}

void
VoxelSums::index()
{
  for (std::size_t s = 0; s < shard_count; ++s)
    shards_[s].places.assign(shards_[s].table.size(), 0);
  for (std::size_t place = 0; place < order_.size(); ++place) {
    const VoxelCode& code = order_[place]->code;
    Shard& shard = shards_[shardOf(code)];
    const std::int64_t number = shard.table.numberOf(code);
    shard.places[static_cast<std::size_t>(number)] =
        static_cast<std::uint32_t>(place + 1);
  }
}

std::int64_t
VoxelSums::find(const Eigen::Vector3f& point) const
{
  if (!frame_.holds(point))
    return -1;
  const VoxelCode code = frame_.codes(point);
  const Shard& shard = shards_[shardOf(code)];
  const std::int64_t number = shard.table.numberOf(code);
  return number < 0 ? -1
                    : std::int64_t{shard.places[static_cast<std::size_t>(number)]} - 1;
}

void
VoxelSums::visit(const PointView& points,
                 const pcl::Indices* indices,
                 unsigned threads,
                 const See& see) const
{
  constexpr std::size_t max_at_once = std::size_t{1} << 20;
  constexpr std::size_t points_a_block = std::size_t{1} << 14;
  const std::size_t n = indices ? indices->size() : points.size();
  const auto at = [&](std::size_t k) {
    return indices ? static_cast<std::size_t>((*indices)[k]) : k;
  };
  const std::size_t parts = resolveThreads(threads);
  std::vector<std::int64_t> found(std::min(n, max_at_once));
  for (std::size_t first = 0; first < n; first += max_at_once) {
    const std::size_t size = std::min(max_at_once, n - first);
    parallelFor(size, points_a_block, threads,
                [&](std::size_t k) { found[k] = find(points[at(first + k)]); });
    parallelBlocks(parts, 1, threads, [&](std::size_t part, std::size_t) {
      const auto low = static_cast<std::int64_t>(part * order_.size() / parts);
      const auto high = static_cast<std::int64_t>((part + 1) * order_.size() / parts);
      for (std::size_t k = 0; k < size; ++k)
        if (found[k] >= low && found[k] < high)
          see(static_cast<std::size_t>(found[k]), at(first + k));
    });
  }
}

} // namespace pcl::sedr
