// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_segmentation/level_columns.h>

#include "level_candidates.h"

#include <pcl/sedr_filters/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace pcl {
namespace sedr {

namespace {

/** @brief Whether any of some columns holds a point within a window of height that
 * only ever rises. */
class RisingWindow {
public:
  RisingWindow(const LevelColumns& columns, const CellBlock& block)
      : columns_(columns)
      , block_(block)
  {
    std::size_t* next = next_.data();
    for (const std::size_t cell : block)
      *next++ = columns.first(cell);
  }

  bool holds(float low, float high)
  {
    const std::vector<Candidate>& all = columns_.all();
    bool is_seen = false;
    std::size_t* next = next_.data();
    for (const std::size_t cell : block_) {
      const std::size_t last = columns_.last(cell);
      while (*next < last && all[*next].z < low)
        ++*next;
      is_seen = is_seen || (*next < last && all[*next].z <= high);
      ++next;
    }
    return is_seen;
  }

private:
  const LevelColumns& columns_;
  const CellBlock& block_;
  std::array<std::size_t, 9> next_{}; ///< first point of each column not below it
};

bool
isLower(const Candidate& a, const Candidate& b)
{
  return a.z != b.z ? a.z < b.z : a.index < b.index;
}

/** @brief Sorts candidates by height: parts side by side, which are merged then. */
void
sortByHeight(std::vector<Candidate>& candidates, unsigned threads)
{
  constexpr std::size_t parts = 8;
  const std::size_t n = candidates.size();
  const auto at = [&](std::size_t part) {
    return candidates.begin() + static_cast<std::ptrdiff_t>(n * part / parts);
  };
  parallelBlocks(parts, 1, threads, [&](std::size_t part, std::size_t next) {
    std::sort(at(part), at(next), isLower);
  });
  for (std::size_t width = 1; width < parts; width *= 2)
    parallelBlocks(parts, 2 * width, threads, [&](std::size_t part, std::size_t next) {
      std::inplace_merge(at(part), at(part + width), at(next), isLower);
    });
}

} // namespace

LevelColumns::LevelColumns(const PointView& points,
                           const std::vector<int>& indices,
                           double cell_size,
                           double tolerance,
                           unsigned threads)
    : points_(points)
    , grid_(cell_size)
    , cells_(grid_, points, indices)
{
  sortIntoColumns(indices, threads);
  leaveOutWalls(tolerance, threads);
}

void
LevelColumns::sortIntoColumns(const std::vector<int>& indices, unsigned threads)
{
  constexpr std::size_t cells_a_block = 4096;
  std::vector<Candidate> unsorted;
  unsorted.reserve(indices.size());
  first_.assign(cells_.size() + 1, 0);
  for (const int i : indices) {
    const Eigen::Vector3f p = points_[static_cast<std::size_t>(i)];
    if (!std::isfinite(p.z()) || !grid_.holds(p.x(), p.y()))
      continue;
    const std::size_t cell = cells_.find(grid_.at(p.x(), p.y()));
    unsorted.push_back({i, static_cast<std::uint32_t>(cell), p.x(), p.y(), p.z()});
    ++first_[cell + 1];
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  std::vector<std::size_t> next(first_.begin(), first_.end());
  all_.resize(unsorted.size());
  for (const Candidate& c : unsorted)
    all_[next[c.cell]++] = c;
  parallelBlocks(
      cells_.size(), cells_a_block, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
          std::sort(all_.begin() + static_cast<std::ptrdiff_t>(first_[i]),
                    all_.begin() + static_cast<std::ptrdiff_t>(first_[i + 1]), isLower);
      });
}

void
LevelColumns::leaveOutWalls(double tolerance, unsigned threads)
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
  parallelBlocks(cells_.size(), cells_a_block, threads, look);
  for (const auto& block : blocks)
    without_walls_.insert(without_walls_.end(), block.begin(), block.end());
  sortByHeight(without_walls_, threads);
}

} // namespace sedr
} // namespace pcl
