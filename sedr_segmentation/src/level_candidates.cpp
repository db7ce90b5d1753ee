// SPDX-License-Identifier: BSD-3-Clause
#include "level_candidates.h"

#include <pcl/sedr_filters/plane_fit.h>

#include <algorithm>
#include <cmath>

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
    for (std::size_t i = 0; i < cells.size(); ++i)
      first_[i + 1] += first_[i];
  }

  /** @brief Whether a column holds a point from height `low` to `high`. */
  bool holds(std::size_t cell, float low, float high) const
  {
    const auto begin = sorted_.begin() + static_cast<std::ptrdiff_t>(first_[cell]);
    const auto end = sorted_.begin() + static_cast<std::ptrdiff_t>(first_[cell + 1]);
    const auto it = std::lower_bound(
        begin, end, low, [](const Candidate& c, float z) { return c.z < z; });
    return it != end && it->z <= high;
  }

private:
  const std::vector<Candidate>& sorted_;
  std::vector<std::size_t> first_; ///< of each cell, and the end
};

} // namespace

std::vector<std::size_t>
blockAround(const CellSet& cells, std::size_t at)
{
  std::vector<std::size_t> block;
  const Cell middle = cells[at];
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx) {
      const std::size_t i = cells.find({middle.x + dx, middle.y + dy});
      if (i != CellSet::npos)
        block.push_back(i);
    }
  return block;
}

std::vector<Candidate>
sortIntoColumns(const PointView& points,
                const std::vector<int>& indices,
                const CellGrid& grid,
                const CellSet& cells)
{
  std::vector<Candidate> columns;
  columns.reserve(indices.size());
  for (const int i : indices) {
    const Eigen::Vector3f p = points[static_cast<std::size_t>(i)];
    if (std::isfinite(p.z()) && grid.holds(p.x(), p.y()))
      columns.push_back({i, p.z(), cells.find(grid.at(p.x(), p.y()))});
  }
  std::sort(columns.begin(), columns.end(), [](const Candidate& a, const Candidate& b) {
    if (a.cell != b.cell)
      return a.cell < b.cell;
    return a.z != b.z ? a.z < b.z : a.index < b.index;
  });
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
  std::vector<std::size_t> block;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    if (i == 0 || sorted[i].cell != sorted[i - 1].cell)
      block = blockAround(cells, sorted[i].cell);
    const float z = sorted[i].z;
    const auto seesWithin = [&](float low, float high) {
      return std::any_of(block.begin(), block.end(), [&](std::size_t cell) {
        return columns.holds(cell, low, high);
      });
    };
    if (!seesWithin(z + near, z + far) || !seesWithin(z - far, z - near))
      horizontal.push_back(sorted[i]);
  }
  std::sort(horizontal.begin(), horizontal.end(),
            [](const Candidate& a, const Candidate& b) {
              return a.z != b.z ? a.z < b.z : a.index < b.index;
            });
  return horizontal;
}

std::vector<std::uint8_t>
columnsThatGoOn(const std::vector<Candidate>& columns,
                const CellSet& cells,
                const PointView& points,
                const PlanSlab& slab,
                double direction,
                double tolerance)
{
  constexpr std::uint8_t away = 1;
  constexpr std::uint8_t close = 2;
  std::vector<std::uint8_t> holds(cells.size(), 0);
  for (const Candidate& c : columns) {
    const double d =
        direction * distanceAbove(slab, points[static_cast<std::size_t>(c.index)]);
    if (d > 1.5 * tolerance && d < 4 * tolerance)
      holds[c.cell] |= d < 2.25 * tolerance ? away | close : away;
  }
  std::vector<std::uint8_t> goes_on(cells.size(), 0);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!holds[i])
      continue;
    const std::vector<std::size_t> block = blockAround(cells, i);
    goes_on[i] = std::any_of(block.begin(), block.end(),
                             [&](std::size_t b) { return holds[b] & close; });
  }
  return goes_on;
}

} // namespace sedr
} // namespace pcl
