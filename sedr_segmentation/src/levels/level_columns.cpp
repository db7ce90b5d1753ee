// SPDX-License-Identifier: BSD-3-Clause
#include "level_columns.h"

#include "../profiles/column_order.h"
#include "level_candidates.h"

#include "sedr_filters/src/base/exactness.h"
#include "sedr_filters/src/base/parallel.h"
#include "sedr_filters/src/base/parallel_for.h"
#include "sedr_filters/src/grids/digit_sort.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief Tests whether any profile has a point in a height window that only moves up.
 */
class RisingWindow {
public:
  RisingWindow(const LevelColumns& columns, const CellBlock& block)
      : heights_(columns.heights().data())
  {
    for (const std::size_t cell : block)
      columns_[size_++] = {columns.first(cell), columns.last(cell)};
  }

  bool holds(float low, float high)
  {
    if (holdsIn(columns_[held_last_], low, high)) // a wall continues in its profile
      return true;
    for (std::size_t k = 0; k < size_; ++k)
      if (holdsIn(columns_[k], low, high)) {
        held_last_ = k;
        return true;
      }
    return false;
  }

private:
  bool holdsIn(ColumnStretch& rest, float low, float high) const
  {
    while (rest.first < rest.last && heights_[rest.first] < low)
      ++rest.first;
    return rest.first < rest.last && heights_[rest.first] <= high;
  }

  const float* heights_;
  std::array<ColumnStretch, 9>
      columns_{}; ///< remaining points, from the first one not below the window
  std::size_t size_ = 0;
  std::size_t held_last_ = 0;
};

bool
isLower(const Candidate& a, const Candidate& b)
{
  return a.z != b.z ? a.z < b.z : a.index < b.index;
}

/** @brief Sorts by height, then by index. O(n) if few heights are equal. */
void
sortByHeight(std::vector<Candidate>& candidates)
{
  sortByDigits(candidates, [](const Candidate& c) { return orderOf(c.z); });
  for (auto first = candidates.begin(); first != candidates.end();) {
    const auto last = std::find_if(first, candidates.end(),
                                   [&](const Candidate& c) { return c.z != first->z; });
    if (last - first > 1)
      std::sort(first, last, isLower);
    first = last;
  }
}

/** @brief Returns increasing heights that divide the candidates about equally. */
std::vector<float>
evenHeights(const std::vector<std::vector<Candidate>>& blocks, std::size_t stretches)
{
  constexpr std::size_t step = 256; // a sample suffices
  std::vector<float> sample;
  for (const auto& block : blocks)
    for (std::size_t k = 0; k < block.size(); k += step)
      sample.push_back(block[k].z);
  std::sort(sample.begin(), sample.end());
  std::vector<float> heights;
  for (std::size_t s = 1; s < stretches && !sample.empty(); ++s)
    heights.push_back(sample[sample.size() * s / stretches]);
  return heights;
}

/** @brief Returns all candidates of the blocks sorted by height; height intervals are
 * sorted in parallel. */
std::vector<Candidate>
sortedByHeight(const std::vector<std::vector<Candidate>>& blocks, unsigned threads)
{
  const std::vector<float> heights = evenHeights(blocks, resolveThreads(threads));
  std::vector<std::vector<Candidate>> stretches(heights.size() + 1);
  std::size_t count = 0;
  for (const auto& block : blocks)
    count += block.size();
  parallelBlocks(stretches.size(), 1, threads, [&](std::size_t s, std::size_t) {
    const auto isWithin = [&](const Candidate& c) {
      return (s == 0 || c.z >= heights[s - 1]) &&
             (s == heights.size() || c.z < heights[s]);
    };
    std::vector<Candidate> own; // avoids false sharing between threads
    own.reserve(count / stretches.size() + count / 16);
    for (const auto& block : blocks)
      std::copy_if(block.begin(), block.end(), std::back_inserter(own), isWithin);
    sortByHeight(own);
    stretches[s] = std::move(own);
  });
  std::vector<std::size_t> first(1, 0);
  for (const auto& stretch : stretches)
    first.push_back(first.back() + stretch.size());
  std::vector<Candidate> sorted(first.back());
  parallelBlocks(stretches.size(), 1, threads, [&](std::size_t s, std::size_t) {
    std::copy(stretches[s].begin(), stretches[s].end(), sorted.data() + first[s]);
  });
  return sorted;
}

} // namespace

LevelColumns::LevelColumns(const PointView& points,
                           const std::vector<int>& indices,
                           double cell_size,
                           double tolerance,
                           unsigned threads)
    : points_(points)
    , grid_(cell_size)
    , threads_(threads)
    , cells_(grid_, points, indices)
    , box_(boxOf(cells_))
{
  sortIntoColumns(indices);
  leaveOutWalls(tolerance);
}

void
LevelColumns::sortIntoColumns(const std::vector<int>& indices)
{
  const ColumnOrder order(
      grid_, points_, indices, cells_.size(),
      [&](Cell cell) { return static_cast<std::uint32_t>(cells_.find(cell)); },
      threads_);
  first_ = order.first();
  all_ = order.sorted<Candidate>(
      [&](std::size_t k, std::uint32_t cell) {
        const Eigen::Vector3f p = points_[static_cast<std::size_t>(indices[k])];
        return Candidate{indices[k], cell, p.x(), p.y(), p.z()};
      },
      isLower);
  heights_.resize(all_.size());
  parallelFor(all_.size(), points_a_block, threads_,
              [&](std::size_t k) { heights_[k] = all_[k].z; });
}

void
LevelColumns::leaveOutWalls(double tolerance)
{
  const auto near = static_cast<float>(tolerance);
  const auto far = static_cast<float>(3 * tolerance);
  std::vector<std::vector<Candidate>> blocks(cells_.size() / cells_a_block + 1);
  const auto look = [&](std::size_t begin, std::size_t end) {
    std::vector<Candidate> horizontal;
    for (std::size_t cell = begin; cell < end; ++cell) {
      const CellBlock block = blockAround(cells_, cell);
      RisingWindow above(*this, block);
      RisingWindow below(*this, block);
      for (std::size_t i = first(cell); i < last(cell); ++i) {
        const float z = heights_[i];
        if (!above.holds(z + near, z + far) || !below.holds(z - far, z - near))
          horizontal.push_back(all_[i]);
      }
    }
    blocks[begin / cells_a_block] = std::move(horizontal);
  };
  parallelBlocks(cells_.size(), cells_a_block, threads_, look);
  without_walls_ = sortedByHeight(blocks, threads_);
}

} // namespace pcl::sedr
