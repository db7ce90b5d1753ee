// SPDX-License-Identifier: BSD-3-Clause
#include "voxel_sums.h"

#include "../base/parallel.h"
#include "voxel_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <numeric>
#include <tuple>
#include <utility>

namespace pcl::sedr {
namespace {

constexpr int cube_bits = 2; // cubes of 4 x 4 x 4 voxels
constexpr std::size_t max_counted = 4096;
constexpr std::size_t voxels_a_block = 4096;

/** @brief How many there are of 0, 1, 2, ... points. */
using Counts = std::array<std::size_t, max_counted + 1>;

/** @brief Returns the number of cubes from one up to the next in the same profile; 0 if
 * they are in two profiles, or 64 cubes apart (13 m at 5 cm): that is no room. */
std::size_t
stepUp(const VoxelSum& from, const VoxelSum& to)
{
  constexpr std::int64_t highest_room = 64;
  const std::int64_t step = std::int64_t{to.code[2]} - from.code[2];
  return from.code[0] != to.code[0] || from.code[1] != to.code[1] || step > highest_room
             ? 0
             : static_cast<std::size_t>(step);
}

VoxelCode
cubeOf(const VoxelCode& voxel)
{
  return {voxel[0] >> cube_bits, voxel[1] >> cube_bits, voxel[2] >> cube_bits};
}

/** @brief Returns how many cubes between the lowest and the highest of their profile
 * hold 0, 1, 2, ... points, and drops the others. O(n log n) for n cubes. */
Counts
keepBetween(VoxelTable& table)
{
  std::vector<VoxelSum> cubes; // by profile, from below
  for (std::size_t c = 0; c < table.size(); ++c)
    cubes.push_back(table[c]);
  std::sort(cubes.begin(), cubes.end(),
            [](const VoxelSum& a, const VoxelSum& b) { return a.code < b.code; });
  Counts counts{};
  std::size_t below = 0; // cubes from the previous one of the profile to this one
  for (std::size_t c = 0; c < cubes.size(); ++c) {
    const std::size_t above = c + 1 < cubes.size() ? stepUp(cubes[c], cubes[c + 1]) : 0;
    counts[0] += std::max<std::size_t>(below, 1) - 1;
    if (below > 0 && above > 0)
      ++counts[std::min<std::size_t>(cubes[c].count, max_counted)];
    else
      table.drop(static_cast<std::size_t>(table.numberOf(cubes[c].code)));
    below = above;
  }
  return counts;
}

} // namespace

/** @brief Points scattered evenly in the air: a Poisson process.
 *
 * Most of the space between the lowest and the highest points of a profile is air. So
 * the counts of the cubes there with the fewest points, a fifth or those of at most one
 * point, are those of strays. */
class VoxelSums::StrayPoints {
public:
  /** @param cubes the sums of all cubes of voxels */
  explicit StrayPoints(VoxelTable cubes)
      : cubes_(std::move(cubes))
  {
    constexpr double share = 0.2;
    constexpr double volume = 1 << 3 * cube_bits;
    const Counts counts = keepBetween(cubes_);
    const std::size_t all =
        std::accumulate(counts.begin(), counts.end(), std::size_t{0});
    std::size_t fewer = 0;
    std::size_t points = 0;
    std::size_t n = 0;
    while (n < max_counted && (n < 1 || static_cast<double>(fewer + counts[n]) <
                                            share * static_cast<double>(all))) {
      fewer += counts[n++];
      points += n * counts[n]; // n times the share of n is the mean times that of n - 1
    }
    voxels_ = volume * static_cast<double>(all);
    if (fewer > 0)
      mean_ = static_cast<double>(points) / static_cast<double>(fewer) / volume;
  }

  /** @brief Returns whether a voxel is in the space between. */
  bool mayHold(const VoxelCode& voxel) const
  {
    const std::int64_t number = cubes_.numberOf(cubeOf(voxel));
    return number >= 0 && cubes_[static_cast<std::size_t>(number)].count > 0;
  }

  /** @brief Returns how many points are strays. */
  double size() const { return mean_ * voxels_; }

  /** @brief Returns the greatest number of points of a window about a voxel of which
   * strays explain at least half of the voxels; 0 if not even those of two.
   * @param seen voxels between by the points of their windows; sparse floors and
   * ceilings, at the ends of profiles, are not among them
   * @param volume of the window, voxels */
  std::size_t explained(const Counts& seen, double volume) const
  {
    const double mean = mean_ * volume;
    const auto first = static_cast<std::size_t>(2 + mean);
    std::size_t n = first;
    for (; n < max_counted; ++n) {
      const auto k = static_cast<double>(n);
      const double expected = voxels_ *
                              std::exp(k * std::log(mean) - mean - std::lgamma(k + 1)) *
                              (1 - std::pow(1 - 1 / volume, k)); // one in the voxel
      if (!(2 * expected >= std::max(1.0, static_cast<double>(seen[n]))))
        break;
    }
    return n > first ? n - 1 : 0;
  }

private:
  VoxelTable cubes_;  ///< those of the space between
  double voxels_ = 0; ///< of the space between
  double mean_ = 0;   ///< strays of a voxel
};

/** @brief The voxels of some hashes, and a lock for threads that add to them. */
struct alignas(64) VoxelSums::Shard {
  VoxelTable table;
  std::vector<std::uint32_t> places; ///< of each voxel in the order plus one; 0: none
  std::mutex mutex;
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
VoxelSums::add(const PointView& points, unsigned threads, const pcl::Indices* indices)
{
  // In the order of a scan, those of a run are in few voxels, which stay in the cache.
  constexpr std::size_t points_a_run = std::size_t{1} << 16;
  const std::size_t n = indices ? indices->size() : points.size();
  parallelBlocks(n, points_a_run, threads, [&](std::size_t begin, std::size_t end) {
    VoxelTable sums;
    for (std::size_t k = begin; k < end; ++k) {
      const Eigen::Vector3f point =
          points[indices ? static_cast<std::size_t>((*indices)[k]) : k];
      if (frame_.holds(point))
        sums.add(frame_.sumOf(point));
    }
    std::array<std::vector<std::size_t>, shard_count> of_shard;
    for (std::size_t v = 0; v < sums.size(); ++v)
      of_shard[shardOf(sums[v].code)].push_back(v);
    for (std::size_t s = 0; s < shard_count; ++s) {
      const std::lock_guard<std::mutex> lock(shards_[s].mutex);
      for (const std::size_t v : of_shard[s])
        shards_[s].table.add(sums[v]);
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

std::size_t
VoxelSums::pointsAround(const VoxelCode& middle, int reach, std::size_t enough) const
{
  std::size_t points = 0;
  for (int x = -reach; x <= reach; ++x)
    for (int y = -reach; y <= reach; ++y)
      for (int z = -reach; z <= reach && points < enough; ++z) {
        const VoxelCode code{middle[0] + x, middle[1] + y, middle[2] + z};
        const VoxelTable& table = shards_[shardOf(code)].table;
        const std::int64_t number = table.numberOf(code);
        points += number < 0 ? 0 : table[static_cast<std::size_t>(number)].count;
      }
  return std::min(points, enough);
}

std::size_t
VoxelSums::strayLimit(const StrayPoints& strays, int reach, unsigned threads) const
{
  const double volume = std::pow(2 * reach + 1, 3);
  Counts seen{};
  const std::size_t bound = strays.explained(seen, volume);
  std::size_t limit = bound;
  for (std::size_t s = 0; s < shard_count && limit > 0; ++s) {
    const VoxelTable& table = shards_[s].table;
    std::vector<std::size_t> around(table.size());
    parallelFor(table.size(), voxels_a_block, threads, [&](std::size_t v) {
      around[v] = strays.mayHold(table[v].code)
                      ? pointsAround(table[v].code, reach, bound + 1)
                      : 0;
    });
    for (const std::size_t points : around)
      ++seen[points];
    limit = strays.explained(seen, volume);
  }
  return limit;
}

std::size_t
VoxelSums::dropStrays(unsigned threads)
{
  constexpr double most = 0.2;       // share of points: more are surfaces seen in dots
  constexpr std::size_t denser = 10; // a surface than strays beside it
  VoxelTable cubes;
  std::size_t all = 0;
  for (std::size_t s = 0; s < shard_count; ++s)
    for (std::size_t v = 0; v < shards_[s].table.size(); ++v) {
      const auto& [code, count, sum] = shards_[s].table[v];
      // Saturated: the cubes of the air hold few points, the others do not matter.
      cubes.add({cubeOf(code), std::min<std::uint32_t>(count, max_counted), {}});
      all += count;
    }
  const StrayPoints strays(std::move(cubes));
  if (strays.size() > most * static_cast<double>(all))
    return 0;
  const std::size_t alone = strayLimit(strays, 0, threads);
  const std::size_t together = strayLimit(strays, 1, threads);
  const std::size_t on_surface = denser * 9 * alone; // 9 of 27 voxels
  std::array<std::vector<std::size_t>, shard_count> of_shard;
  parallelFor(shard_count, 1, threads, [&](std::size_t s) {
    const VoxelTable& table = shards_[s].table;
    for (std::size_t v = 0; v < table.size(); ++v) {
      if (table[v].count > std::max(alone, together))
        continue;
      const std::size_t around =
          pointsAround(table[v].code, 1, std::max(on_surface, together + 1));
      if (around <= together || (table[v].count <= alone && around >= on_surface))
        of_shard[s].push_back(v);
    }
  });
  std::size_t dropped = 0;
  for (std::size_t s = 0; s < shard_count; ++s)
    for (const std::size_t v : of_shard[s])
      dropped += shards_[s].table.drop(v);
  return dropped;
}

std::size_t
VoxelSums::arrange(std::uint32_t min_points)
{
  struct Entry {
    VoxelCode code;
    const VoxelSum* sum;
  };
  std::vector<Entry> entries;
  entries.reserve(size());
  for (std::size_t s = 0; s < shard_count; ++s)
    for (std::size_t v = 0; v < shards_[s].table.size(); ++v)
      if (const VoxelSum& sum = shards_[s].table[v];
          sum.count >= std::max(min_points, 1U))
        entries.push_back({sum.code, &sum});
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return std::tie(a.code[2], a.code[1], a.code[0]) <
           std::tie(b.code[2], b.code[1], b.code[0]);
  });
  order_.resize(entries.size());
  std::transform(entries.begin(), entries.end(), order_.begin(),
                 [](const Entry& entry) { return entry.sum; });
  return order_.size();
}

std::vector<VoxelSum>
VoxelSums::take()
{
  arrange();
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
  constexpr std::size_t points_a_block = std::size_t{1} << 16;
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
