// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_segmentation/level_columns.h>

#include "level_candidates.h"

#include <pcl/sedr_filters/digit_sort.h>
#include <pcl/sedr_filters/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace pcl {
namespace sedr {

namespace {

/** @brief Whether any of some columns holds a point within a window of height that
 * only ever rises. */
class RisingWindow {
public:
  RisingWindow(const LevelColumns& columns, const CellBlock& block)
      : all_(columns.all().data())
  {
    for (const std::size_t cell : block)
      columns_[size_++] = {columns.first(cell), columns.last(cell)};
  }

  bool holds(float low, float high)
  {
    if (holdsIn(columns_[held_last_], low, high)) // a wall goes on in its column
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
    while (rest.first < rest.last && all_[rest.first].z < low)
      ++rest.first;
    return rest.first < rest.last && all_[rest.first].z <= high;
  }

  const Candidate* all_;
  std::array<ColumnStretch, 9> columns_{}; ///< from the first point not below it
  std::size_t size_ = 0;
  std::size_t held_last_ = 0;
};

bool
isLower(const Candidate& a, const Candidate& b)
{
  return a.z != b.z ? a.z < b.z : a.index < b.index;
}

/** @brief Sorts by height, and those as high as each other by index. O(n) where few
 * are. */
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
  constexpr std::size_t cells_a_block = 4096;
  constexpr std::size_t points_a_block = 16384;
  constexpr auto nowhere = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> cell_of(indices.size());
  parallelBlocks(
      indices.size(), points_a_block, threads_,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
          const Eigen::Vector3f p = points_[static_cast<std::size_t>(indices[k])];
          const bool is_held = std::isfinite(p.z()) && grid_.holds(p.x(), p.y());
          cell_of[k] =
              is_held ? static_cast<std::uint32_t>(cells_.find(grid_.at(p.x(), p.y())))
                      : nowhere;
        }
      });
  first_.assign(cells_.size() + 1, 0);
  for (const std::uint32_t cell : cell_of)
    if (cell != nowhere)
      ++first_[cell + 1];
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  std::vector<std::size_t> next(first_.begin(), first_.end());
  all_.resize(first_.back());
  for (std::size_t k = 0; k < indices.size(); ++k) {
    if (cell_of[k] == nowhere)
      continue;
    const Eigen::Vector3f p = points_[static_cast<std::size_t>(indices[k])];
    all_[next[cell_of[k]]++] = {indices[k], cell_of[k], p.x(), p.y(), p.z()};
  }
  parallelBlocks(
      cells_.size(), cells_a_block, threads_, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          Candidate* const column = all_.data() + first_[i];
          Candidate* const end_of_column = all_.data() + first_[i + 1];
          if (!std::is_sorted(column, end_of_column, isLower)) // as thinned points are
            std::sort(column, end_of_column, isLower);
        }
      });
}

void
LevelColumns::leaveOutWalls(double tolerance)
{
  constexpr std::size_t cells_a_block = 4096;
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
        const float z = all_[i].z;
        if (!above.holds(z + near, z + far) || !below.holds(z - far, z - near))
          horizontal.push_back(all_[i]);
      }
    }
    blocks[begin / cells_a_block] = std::move(horizontal);
  };
  parallelBlocks(cells_.size(), cells_a_block, threads_, look);
  std::size_t count = 0;
  for (const auto& block : blocks)
    count += block.size();
  without_walls_.reserve(count);
  for (const auto& block : blocks)
    without_walls_.insert(without_walls_.end(), block.begin(), block.end());
  sortByHeight(without_walls_);
}

} // namespace sedr
} // namespace pcl
