// SPDX-License-Identifier: BSD-3-Clause
#include "voxel_sums.h"

#include "../base/parallel.h"
#include "../base/parallel_for.h"
#include "voxel_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>
#include <numeric>
#include <tuple>

namespace pcl::sedr {
namespace {

constexpr double cube_volume = 64; // voxels
constexpr std::size_t max_counted = 4096;

/** @brief Returns the number of cubes from one up to the next in the same profile; 0 if
 * they are in two profiles, or 64 cubes apart (13 m at 5 cm): that is no room. */
double
stepUp(const VoxelSum& from, const VoxelSum& to)
{
  constexpr double highest_room = 64;
  if (from.code[0] != to.code[0] || from.code[1] != to.code[1])
    return 0;
  const double step = static_cast<double>(to.code[2]) - from.code[2];
  return step > highest_room ? 0 : step;
}

/** @brief Estimates how many points distinguish a voxel on a surface from one with
 * points scattered in the air.
 *
 * A single stray occupies a voxel as a thousand points of a wall do. In a dense scan,
 * one stray in a hundred points is enough to fill a tenth of a room's voxels. Most of
 * the space between floor and ceiling is air. So the cubes of 4 x 4 x 4 voxels between
 * a lower and a higher cube of their profile hold strays, if most of them hold points.
 */
class VoxelCensus {
public:
  /** @brief Counts a voxel. */
  void add(const VoxelCode& voxel, std::uint32_t points)
  {
    constexpr unsigned edge_bits = 2;
    // Saturated: the cubes of the air hold few points, the others do not matter.
    constexpr std::uint32_t most = std::numeric_limits<std::uint32_t>::max() / 64;
    if (points == 0)
      return;
    const VoxelCode cube{voxel[0] >> edge_bits, voxel[1] >> edge_bits,
                         voxel[2] >> edge_bits};
    cubes_.add({cube, std::min(points, most), {}});
    points_by_count_.resize(max_counted + 1, 0);
    points_by_count_[std::min<std::size_t>(points, max_counted)] += points;
  }

  /** @brief Returns the minimum number of points of a voxel on a surface; about one in
   * a hundred voxels of strays reaches it. 0 (keep all) unless there are at least 50
   * cubes between the lowest and the highest of their profile, of which four fifths
   * hold points; and if half of the points lie in voxels with less than ten times as
   * many: the scan is too sparse to decide. O(n log n) for n cubes. */
  std::uint32_t minPoints() const
  {
    constexpr double denser = 10; // ratio of the densities of surfaces and strays
    const double in_air = pointsInAir();
    if (in_air == 0)
      return 0;
    // Counts of independent strays deviate by their square roots.
    const double mean = (in_air + std::sqrt(in_air)) / cube_volume;
    const double least = 2 + std::floor(mean + 2.5 * std::sqrt(mean));
    return static_cast<double>(middleCount()) >= denser * least
               ? static_cast<std::uint32_t>(least)
               : 0;
  }

private:
  /** @brief Returns the 20th percentile of the points of the cubes between the lowest
   * and the highest of their profile, empty ones included; 0 if there are few. */
  double pointsInAir() const
  {
    constexpr double share = 0.2;
    constexpr double few = 50;   // cubes
    std::vector<VoxelSum> cubes; // by profile, from below
    for (std::size_t c = 0; c < cubes_.size(); ++c)
      cubes.push_back(cubes_[c]);
    std::sort(cubes.begin(), cubes.end(),
              [](const VoxelSum& a, const VoxelSum& b) { return a.code < b.code; });
    std::vector<std::uint32_t> occupied;
    double all = 0;
    double below = 0; // cubes from the previous one of the profile to this one
    for (std::size_t i = 0; i < cubes.size(); ++i) {
      const double above = i + 1 < cubes.size() ? stepUp(cubes[i], cubes[i + 1]) : 0;
      if (below > 0)
        all += below - 1;
      if (below > 0 && above > 0) {
        ++all;
        occupied.push_back(cubes[i].count);
      }
      below = above;
    }
    const double rank =
        std::floor(share * all) - (all - static_cast<double>(occupied.size()));
    if (all < few || rank < 0)
      return 0;
    const auto at = occupied.begin() + static_cast<std::ptrdiff_t>(rank);
    std::nth_element(occupied.begin(), at, occupied.end());
    return *at;
  }

  /** @brief Returns the count that half of the points have in their voxel, or more. */
  std::size_t middleCount() const
  {
    const std::uint64_t all = std::accumulate(points_by_count_.begin(),
                                              points_by_count_.end(), std::uint64_t{0});
    std::uint64_t above = 0;
    std::size_t count = points_by_count_.size();
    while (count > 0 && 2 * above < all)
      above += points_by_count_[--count];
    return count;
  }

  VoxelTable cubes_;                           ///< of which only the counts are used
  std::vector<std::uint64_t> points_by_count_; ///< in voxels of 0, 1, 2, ... points
};

} // namespace

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
VoxelSums::add(const PointView& points,
               unsigned threads,
               const pcl::Indices* indices,
               const RowSource::SeeRun& beside)
{
  // In the order of a scan, those of a run are in few voxels, which stay in the cache.
  constexpr std::size_t points_a_run = std::size_t{1} << 16;
  const std::size_t n = indices ? indices->size() : points.size();
  parallelBlocks(n, points_a_run, threads, [&](std::size_t begin, std::size_t end) {
    if (beside)
      beside(begin, end);
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
      if (const VoxelSum& sum = shards_[s].table[v]; sum.count >= min_points)
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
