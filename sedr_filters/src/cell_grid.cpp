// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_filters/cell_grid.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <numeric>

namespace pcl {
namespace sedr {

namespace {

/** @brief Disjoint sets with path halving; the smaller root wins, so that labels do not
 * depend on the order of unions. */
class DisjointSets {
public:
  explicit DisjointSets(std::size_t n)
      : parent_(n)
  {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }

  std::size_t root(std::size_t i)
  {
    while (parent_[i] != i)
      i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  void join(std::size_t a, std::size_t b)
  {
    a = root(a);
    b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

private:
  std::vector<std::size_t> parent_;
};

/** @brief Joins every cell with its eight neighbours: the one before it in the row, and
 * the up to three in the row below, which a second cursor follows. */
void
joinNeighbours(const CellSet& cells, DisjointSets& sets)
{
  std::size_t below = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Cell cell = cells[i];
    if (i > 0 && cells[i - 1].y == cell.y && cells[i - 1].x + 1 == cell.x)
      sets.join(i - 1, i);
    const auto isBefore = [&](Cell other) {
      return other.y < cell.y - 1 || (other.y == cell.y - 1 && other.x < cell.x - 1);
    };
    while (below < i && isBefore(cells[below]))
      ++below;
    for (std::size_t j = below; j < i; ++j) {
      const Cell other = cells[j];
      if (other.y != cell.y - 1 || other.x > cell.x + 1)
        break;
      sets.join(i, j);
    }
  }
}

} // namespace

bool
CellGrid::holds(double x, double y) const
{
  constexpr double limit = std::numeric_limits<std::int32_t>::max() - 16.0;
  return std::abs(x / size_) < limit && std::abs(y / size_) < limit;
}

Cell
CellGrid::at(double x, double y) const
{
  assert(holds(x, y));
  return {static_cast<std::int32_t>(std::floor(x / size_)),
          static_cast<std::int32_t>(std::floor(y / size_))};
}

CellSet::CellSet(std::vector<CellKey> keys)
    : keys_(std::move(keys))
{
  std::sort(keys_.begin(), keys_.end());
  keys_.erase(std::unique(keys_.begin(), keys_.end()), keys_.end());
}

CellSet
CellSet::fromSorted(std::vector<CellKey> keys)
{
  assert(std::adjacent_find(keys.begin(), keys.end(), std::greater_equal<>()) ==
         keys.end());
  CellSet set;
  set.keys_ = std::move(keys);
  return set;
}

std::size_t
CellSet::find(Cell cell) const
{
  const CellKey key = keyOf(cell);
  const auto it = std::lower_bound(keys_.begin(), keys_.end(), key);
  return it != keys_.end() && *it == key ? static_cast<std::size_t>(it - keys_.begin())
                                         : npos;
}

CellSet
unite(const CellSet& a, const CellSet& b)
{
  std::vector<CellKey> keys;
  std::set_union(a.keys().begin(), a.keys().end(), b.keys().begin(), b.keys().end(),
                 std::back_inserter(keys));
  return CellSet::fromSorted(std::move(keys));
}

CellSet
intersect(const CellSet& a, const CellSet& b)
{
  std::vector<CellKey> keys;
  std::set_intersection(a.keys().begin(), a.keys().end(), b.keys().begin(),
                        b.keys().end(), std::back_inserter(keys));
  return CellSet::fromSorted(std::move(keys));
}

CellSet
subtract(const CellSet& a, const CellSet& b)
{
  std::vector<CellKey> keys;
  std::set_difference(a.keys().begin(), a.keys().end(), b.keys().begin(),
                      b.keys().end(), std::back_inserter(keys));
  return CellSet::fromSorted(std::move(keys));
}

CellRegions
labelRegions(const CellSet& cells)
{
  DisjointSets sets(cells.size());
  joinNeighbours(cells, sets);

  // Roots are the first cells of their regions, so regions are met in the order of the
  // keys.
  CellRegions regions;
  regions.label.resize(cells.size());
  std::vector<std::size_t> region_of_root(cells.size());
  std::vector<std::size_t> sizes;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::size_t root = sets.root(i);
    if (root == i) {
      region_of_root[i] = sizes.size();
      sizes.push_back(0);
    }
    regions.label[i] = region_of_root[root];
    ++sizes[regions.label[i]];
  }

  std::vector<std::size_t> order(sizes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return sizes[a] > sizes[b]; });
  std::vector<std::size_t> rank(sizes.size());
  for (std::size_t r = 0; r < order.size(); ++r) {
    rank[order[r]] = r;
    regions.sizes.push_back(sizes[order[r]]);
  }
  for (auto& label : regions.label)
    label = rank[label];
  return regions;
}

} // namespace sedr
} // namespace pcl
