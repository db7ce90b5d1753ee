// SPDX-License-Identifier: BSD-3-Clause
#include "level_candidates.h"

#include <pcl/sedr_filters/plane_fit.h>
#include <pcl/sedr_segmentation/ceiling_gap.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl {
namespace sedr {

namespace {

/** @brief Candidates sorted by cell and height, reached by cell. */
class Columns {
public:
  Columns(const std::vector<Candidate>& sorted, const CellSet& cells)
      : sorted_(sorted)
      , first_(cells.size() + 1, 0)
  {
    for (const Candidate& c : sorted)
      ++first_[c.cell + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
  }

  std::size_t first(std::size_t cell) const { return first_[cell]; }
  std::size_t last(std::size_t cell) const { return first_[cell + 1]; }

  const Candidate& operator[](std::size_t i) const { return sorted_[i]; }

private:
  const std::vector<Candidate>& sorted_;
  std::vector<std::size_t> first_; ///< of each cell, and the end
};

/** @brief Whether any of some columns holds a point within a window of height that
 * only ever rises. */
class RisingWindow {
public:
  RisingWindow(const Columns& columns, const CellBlock& block)
      : columns_(columns)
      , block_(block)
  {
    std::size_t* next = next_.data();
    for (const std::size_t cell : block)
      *next++ = columns.first(cell);
  }

  bool holds(float low, float high)
  {
    bool is_seen = false;
    std::size_t* next = next_.data();
    for (const std::size_t cell : block_) {
      const std::size_t last = columns_.last(cell);
      while (*next < last && columns_[*next].z < low)
        ++*next;
      is_seen = is_seen || (*next < last && columns_[*next].z <= high);
      ++next;
    }
    return is_seen;
  }

private:
  const Columns& columns_;
  const CellBlock& block_;
  std::array<std::size_t, 9> next_{}; ///< first point of each column not below it
};

bool
isLower(const Candidate& a, const Candidate& b)
{
  return a.z != b.z ? a.z < b.z : a.index < b.index;
}

} // namespace

CellBlock
blockAround(const CellSet& cells, std::size_t at)
{
  CellBlock block;
  const Cell middle = cells[at];
  for (int dy = -1; dy <= 1; ++dy) {
    // Cells side by side follow one another in the set.
    std::size_t i = CellSet::npos;
    for (int dx = -1; dx <= 1 && i == CellSet::npos; ++dx)
      i = cells.find({middle.x + dx, middle.y + dy});
    const CellKey last = keyOf({middle.x + 1, middle.y + dy});
    for (; i < cells.size() && cells.keys()[i] <= last; ++i)
      block.add(i);
  }
  return block;
}

std::vector<Candidate>
sortIntoColumns(const PointView& points,
                const std::vector<int>& indices,
                const CellGrid& grid,
                const CellSet& cells)
{
  std::vector<Candidate> unsorted;
  unsorted.reserve(indices.size());
  std::vector<std::size_t> next(cells.size() + 1, 0);
  for (const int i : indices) {
    const Eigen::Vector3f p = points[static_cast<std::size_t>(i)];
    if (!std::isfinite(p.z()) || !grid.holds(p.x(), p.y()))
      continue;
    const std::size_t cell = cells.find(grid.at(p.x(), p.y()));
    unsorted.push_back({i, static_cast<std::uint32_t>(cell), p.x(), p.y(), p.z()});
    ++next[cell + 1];
  }
  std::partial_sum(next.begin(), next.end(), next.begin());
  std::vector<Candidate> columns(unsorted.size());
  for (const Candidate& c : unsorted)
    columns[next[c.cell]++] = c;
  for (std::size_t i = 0, first = 0; i < cells.size(); first = next[i++])
    std::sort(columns.begin() + static_cast<std::ptrdiff_t>(first),
              columns.begin() + static_cast<std::ptrdiff_t>(next[i]), isLower);
  return columns;
}

std::vector<Candidate>
withoutWalls(const std::vector<Candidate>& sorted,
             const CellSet& cells,
             double tolerance)
{
  const Columns columns(sorted, cells);
  const auto near = static_cast<float>(tolerance);
  const auto far = static_cast<float>(3 * tolerance);
  std::vector<Candidate> horizontal;
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    const CellBlock block = blockAround(cells, cell);
    RisingWindow above(columns, block);
    RisingWindow below(columns, block);
    for (std::size_t i = columns.first(cell); i < columns.last(cell); ++i) {
      const float z = sorted[i].z;
      if (!above.holds(z + near, z + far) || !below.holds(z - far, z - near))
        horizontal.push_back(sorted[i]);
    }
  }
  std::sort(horizontal.begin(), horizontal.end(), isLower);
  return horizontal;
}

std::vector<std::uint8_t>
columnsThatGoOn(const std::vector<Candidate>& columns,
                const CellSet& cells,
                const PlanSlab& slab,
                double direction,
                double tolerance)
{
  constexpr std::uint8_t away = 1;
  constexpr std::uint8_t close = 2;
  constexpr std::uint8_t joined = 4;
  const CeilingGap gap = gapBelow(slab);
  std::vector<std::uint8_t> holds(cells.size(), 0);
  for (const Candidate& c : columns) {
    const double d = direction * distanceAbove(slab, c.position());
    if (d > 1.5 * tolerance && d < 4 * tolerance)
      holds[c.cell] |= d < 2.25 * tolerance ? away | close : away;
    if (direction > 0 || (d > gap.high && d < gap.low))
      holds[c.cell] |= joined;
  }
  std::vector<std::uint8_t> goes_on(cells.size(), 0);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!(holds[i] & away))
      continue;
    const CellBlock block = blockAround(cells, i);
    const auto anyHolds = [&](std::uint8_t what) {
      return std::any_of(block.begin(), block.end(),
                         [&](std::size_t b) { return (holds[b] & what) != 0; });
    };
    goes_on[i] = anyHolds(close) && anyHolds(joined) ? 1 : 0;
  }
  return goes_on;
}

} // namespace sedr
} // namespace pcl
