// SPDX-License-Identifier: BSD-3-Clause
#include "axis_ranks.h"

#include <pcl/sedr_filters/parallel.h>
#include <pcl/sedr_filters/voxel_partition.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <utility>

namespace pcl {
namespace sedr {

namespace {

constexpr std::size_t points_per_piece = 1 << 16;

using Codes = std::array<std::int32_t, 3>;

Codes
codesOf(const Eigen::Vector3f& p, const Eigen::Array3f& inverse_leaf)
{
  return {codeOf(p.x() * inverse_leaf.x()), codeOf(p.y() * inverse_leaf.y()),
          codeOf(p.z() * inverse_leaf.z())};
}

bool
isFinite(const Eigen::Vector3f& p)
{
  return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
}

using BoxRanks = std::array<AxisRanks, 3>;

/** @brief Gives each point the key of its voxel: the ranks of z, y and x side by side.
 */
class VoxelKeys {
public:
  VoxelKeys(const PointView& points,
            const Eigen::Array3f& inverse_leaf,
            const BoxRanks& ranks)
      : points_(points)
      , inverse_leaf_(inverse_leaf)
      , ranks_(ranks)
      , x_bits_(ranks[0].bits())
      , y_bits_(ranks[1].bits())
      , row_bits_(y_bits_ + ranks[2].bits())
  {}

  /** @brief Where z, y and x take more than 64 bits, numbers the rows of voxels that
   * occur, which take no more than 32. */
  void shorten(const pcl::Indices& indices)
  {
    if (bits() <= 64)
      return;
    Cursor cursor(*this);
    std::vector<std::uint64_t> rows;
    for (const auto i : indices)
      if (points_.isFinite(static_cast<std::size_t>(i)))
        rows.push_back(cursor.row(points_[static_cast<std::size_t>(i)]));
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    rows_.swap(rows);
    row_bits_ = 32;
  }

  unsigned bits() const { return row_bits_ + x_bits_; }

  /** @brief Looks up keys; one a thread. */
  class Cursor {
  public:
    explicit Cursor(const VoxelKeys& keys)
        : keys_(keys)
        , x_(keys.ranks_[0])
        , y_(keys.ranks_[1])
        , z_(keys.ranks_[2])
    {}

    std::uint64_t row(const Eigen::Vector3f& p)
    {
      const std::uint64_t z = z_(codeOf(p.z() * keys_.inverse_leaf_.z()));
      return z << keys_.y_bits_ | y_(codeOf(p.y() * keys_.inverse_leaf_.y()));
    }

    std::uint64_t operator()(const Eigen::Vector3f& p)
    {
      std::uint64_t key = row(p);
      if (!keys_.rows_.empty())
        key = static_cast<std::uint64_t>(
            std::lower_bound(keys_.rows_.begin(), keys_.rows_.end(), key) -
            keys_.rows_.begin());
      return key << keys_.x_bits_ | x_(codeOf(p.x() * keys_.inverse_leaf_.x()));
    }

  private:
    const VoxelKeys& keys_;
    AxisRanks::Cursor x_;
    AxisRanks::Cursor y_;
    AxisRanks::Cursor z_;
  };

private:
  const PointView& points_;
  const Eigen::Array3f& inverse_leaf_;
  const BoxRanks& ranks_;
  unsigned x_bits_;
  unsigned y_bits_;
  unsigned row_bits_;
  std::vector<std::uint64_t> rows_;
};

/** @brief Few large pieces of [0, n), for what is stored a thread. */
struct Pieces {
  Pieces(std::size_t n, unsigned threads)
      : size(n)
      , count(std::min<std::size_t>(threads, n / points_per_piece + 1))
      , each((n + count - 1) / count)
  {}

  /** @brief Calls `body(piece, begin, end)`, one thread a piece. */
  template <typename BodyT>
  void forEach(const BodyT& body) const
  {
    parallelBlocks(
        size, each, static_cast<unsigned>(count),
        [&](std::size_t begin, std::size_t end) { body(begin / each, begin, end); });
  }

  std::size_t size;
  std::size_t count;
  std::size_t each;
};

/** @brief Finds the coordinates that occur; fills the box of `partition`. */
BoxRanks
rankAxes(const PointView& points,
         const pcl::Indices& indices,
         const Eigen::Array3f& inverse_leaf,
         unsigned threads,
         VoxelPartition& partition)
{
  const Pieces pieces(indices.size(), threads);
  constexpr float infinity = std::numeric_limits<float>::infinity();
  std::vector<BoxRanks> found;
  for (std::size_t k = 0; k < pieces.count; ++k)
    found.push_back({AxisRanks(indices.size()), AxisRanks(indices.size()),
                     AxisRanks(indices.size())});
  std::vector<Eigen::Array3f> low(pieces.count, Eigen::Array3f::Constant(infinity));
  std::vector<Eigen::Array3f> high(pieces.count, Eigen::Array3f::Constant(-infinity));
  pieces.forEach([&](std::size_t k, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Eigen::Vector3f p = points[static_cast<std::size_t>(indices[i])];
      if (!isFinite(p))
        continue;
      low[k] = low[k].min(p.array());
      high[k] = high[k].max(p.array());
      const Codes codes = codesOf(p, inverse_leaf);
      for (std::size_t axis = 0; axis < 3; ++axis)
        found[k][axis].mark(codes[axis]);
    }
  });

  for (std::size_t k = 1; k < pieces.count; ++k) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      found[0][axis].merge(found[k][axis]);
    low[0] = low[0].min(low[k]);
    high[0] = high[0].max(high[k]);
  }
  for (auto& axis : found[0])
    axis.number();
  if (low[0].x() <= high[0].x()) {
    partition.min = voxelOf(low[0], inverse_leaf);
    partition.max = voxelOf(high[0], inverse_leaf);
  }
  return std::move(found[0]);
}

/** @brief A point by what its bucket leaves of the key of its voxel. */
template <typename KeyT>
struct KeyedPoint {
  KeyT key;
  pcl::index_t index;
};

/** @brief Points by bucket, which is the leading bits of their keys: those of bucket b
 * are points[begin[b]] to points[begin[b + 1]], as they were given. */
template <typename KeyT>
struct Buckets {
  std::unique_ptr<KeyedPoint<KeyT>[]> points; ///< not worth zeroing
  std::vector<std::size_t> begin;
};

/** @brief A stable counting sort by all but the last `low_bits` of the keys. */
template <typename KeyT>
Buckets<KeyT>
fillBuckets(const PointView& points,
            const pcl::Indices& indices,
            const VoxelKeys& keys,
            unsigned low_bits,
            unsigned threads)
{
  constexpr std::uint16_t none = 0xffff;
  const std::size_t count = std::size_t{1} << (keys.bits() - low_bits);
  const std::uint64_t low_mask =
      low_bits < 64 ? (std::uint64_t{1} << low_bits) - 1 : ~0ull;
  const Pieces pieces(indices.size(), threads);
  const std::unique_ptr<KeyT[]> low(new KeyT[indices.size()]); // not worth zeroing
  std::vector<std::uint16_t> bucket_of(indices.size(), none);
  std::vector<std::vector<std::size_t>> next(pieces.count,
                                             std::vector<std::size_t>(count, 0));
  pieces.forEach([&](std::size_t piece, std::size_t begin, std::size_t end) {
    VoxelKeys::Cursor key_of(keys);
    for (std::size_t i = begin; i < end; ++i) {
      const Eigen::Vector3f p = points[static_cast<std::size_t>(indices[i])];
      if (!isFinite(p))
        continue;
      const std::uint64_t key = key_of(p);
      low[i] = static_cast<KeyT>(key & low_mask);
      bucket_of[i] = static_cast<std::uint16_t>(low_bits < 64 ? key >> low_bits : 0);
      ++next[piece][bucket_of[i]];
    }
  });

  Buckets<KeyT> buckets;
  std::size_t total = 0;
  for (std::size_t b = 0; b < count; ++b) {
    buckets.begin.push_back(total);
    for (auto& of_piece : next)
      total += std::exchange(of_piece[b], total);
  }
  buckets.begin.push_back(total);
  buckets.points.reset(new KeyedPoint<KeyT>[total]);
  pieces.forEach([&](std::size_t piece, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      if (bucket_of[i] != none)
        buckets.points[next[piece][bucket_of[i]]++] = {low[i], indices[i]};
  });
  return buckets;
}

/** @brief Sorts [first, last) by the last `bits` bits of the keys, stably. */
template <typename PointT>
void
sortByKey(PointT* first, PointT* last, unsigned bits, std::vector<PointT>& scratch)
{
  constexpr unsigned most_bits = 12;
  const auto size = static_cast<std::size_t>(last - first);
  if (size < 256) {
    std::stable_sort(first, last,
                     [](const PointT& a, const PointT& b) { return a.key < b.key; });
    return;
  }
  scratch.resize(size);
  const unsigned passes = (bits + most_bits - 1) / most_bits;
  const unsigned digit_bits = passes > 0 ? (bits + passes - 1) / passes : 0;
  const std::size_t digits = std::size_t{1} << digit_bits;
  std::vector<std::size_t> next;
  for (unsigned pass = 0; pass < passes; ++pass) {
    const auto digit = [&](const PointT& p) {
      return static_cast<std::size_t>(p.key >> (pass * digit_bits)) & (digits - 1);
    };
    next.assign(digits + 1, 0);
    for (const auto* p = first; p != last; ++p)
      ++next[digit(*p) + 1];
    std::partial_sum(next.begin(), next.end(), next.begin());
    for (const auto* p = first; p != last; ++p)
      scratch[next[digit(*p)]++] = *p;
    std::copy(scratch.begin(), scratch.begin() + static_cast<std::ptrdiff_t>(size),
              first);
  }
}

/** @brief Sorts the points by voxel: into buckets, then every bucket by itself. */
template <typename KeyT>
void
sortPoints(const PointView& points,
           const pcl::Indices& indices,
           const VoxelKeys& keys,
           unsigned low_bits,
           unsigned threads,
           VoxelPartition& partition)
{
  auto buckets = fillBuckets<KeyT>(points, indices, keys, low_bits, threads);
  partition.order.resize(buckets.begin.back());
  std::vector<std::vector<std::size_t>> starts(buckets.begin.size() - 1);
  parallelBlocks(starts.size(), 1, threads, [&](std::size_t b, std::size_t) {
    auto* const all = buckets.points.get();
    std::vector<KeyedPoint<KeyT>> scratch;
    sortByKey(all + buckets.begin[b], all + buckets.begin[b + 1], low_bits, scratch);
    for (std::size_t i = buckets.begin[b]; i < buckets.begin[b + 1]; ++i) {
      if (i == buckets.begin[b] || all[i - 1].key != all[i].key)
        starts[b].push_back(i);
      partition.order[i] = all[i].index;
    }
  });
  for (const auto& some : starts)
    partition.begin.insert(partition.begin.end(), some.begin(), some.end());
  partition.begin.push_back(partition.order.size());
}

} // namespace

Eigen::Vector3i
voxelOf(const Eigen::Vector3f& p, const Eigen::Array3f& inverse_leaf)
{
  Eigen::Vector3i voxel;
  for (int axis = 0; axis < 3; ++axis) {
    const double cell = std::floor(p[axis] * inverse_leaf[axis]);
    voxel[axis] = static_cast<int>(
        std::clamp(cell, static_cast<double>(std::numeric_limits<int>::min()),
                   static_cast<double>(std::numeric_limits<int>::max())));
  }
  return voxel;
}

VoxelPartition
partitionVoxels(const PointView& points,
                const pcl::Indices& indices,
                const Eigen::Array3f& inverse_leaf,
                unsigned threads)
{
  constexpr unsigned most_bucket_bits = 12;
  threads = resolveThreads(threads);
  VoxelPartition partition;
  const BoxRanks ranks = rankAxes(points, indices, inverse_leaf, threads, partition);
  VoxelKeys keys(points, inverse_leaf, ranks);
  keys.shorten(indices);
  const unsigned low_bits = keys.bits() - std::min(keys.bits(), most_bucket_bits);
  if (low_bits <= 32)
    sortPoints<std::uint32_t>(points, indices, keys, low_bits, threads, partition);
  else
    sortPoints<std::uint64_t>(points, indices, keys, low_bits, threads, partition);
  return partition;
}

} // namespace sedr
} // namespace pcl
