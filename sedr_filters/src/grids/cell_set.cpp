// SPDX-License-Identifier: BSD-3-Clause
#include "cell_set.h"
#include "disjoint_sets.h"

#include <functional>
#include <iterator>
#include <numeric>

namespace pcl::sedr {

namespace {

/** @brief Joins every cell with its eight neighbours: the previous one in its row, and
 * up to three in the row below, followed by a second cursor. Skips those that are
 * already joined. */
void
joinNeighbours(const CellSet& cells, DisjointSets<std::size_t>& sets)
{
  const std::vector<CellKey>& keys = cells.keys();
  const auto followsAnother = [&](std::size_t i) {
    return i > 0 && keys[i - 1] + 1 == keys[i];
  };
  std::size_t below = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Cell cell = cells[i];
    const bool goes_on = followsAnother(i);
    if (goes_on)
      sets.join(i - 1, i);
    const CellKey first = keyOf({cell.x - 1, cell.y - 1});
    while (keys[below] < first)
      ++below;
    const CellKey fresh = goes_on ? first + 2 : first; // without a left neighbour
    for (std::size_t j = below; keys[j] <= first + 2; ++j)
      if (keys[j] >= fresh && (keys[j] == first || !followsAnother(j)))
        sets.join(i, j);
  }
}

} // namespace

CellSet::CellSet(std::vector<CellKey> keys)
    : keys_(std::move(keys))
{
  std::sort(keys_.begin(), keys_.end());
  keys_.erase(std::unique(keys_.begin(), keys_.end()), keys_.end());
  indexRows();
}

CellSet
CellSet::fromSorted(std::vector<CellKey> keys)
{
  assert(std::adjacent_find(keys.begin(), keys.end(), std::greater_equal<>()) ==
         keys.end());
  CellSet set;
  set.keys_ = std::move(keys);
  set.indexRows();
  return set;
}

/** @brief Stores the starts of the rows, unless there are more rows than cells. */
void
CellSet::indexRows()
{
  row_.clear();
  if (keys_.empty())
    return;
  first_row_ = cellOf(keys_.front()).y;
  const std::int64_t rows = std::int64_t{cellOf(keys_.back()).y} - first_row_ + 1;
  if (static_cast<std::uint64_t>(rows) > keys_.size())
    return;
  row_.assign(static_cast<std::size_t>(rows) + 1, 0);
  for (const CellKey key : keys_)
    ++row_[static_cast<std::size_t>(cellOf(key).y - first_row_) + 1];
  std::partial_sum(row_.begin(), row_.end(), row_.begin());
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
  DisjointSets<std::size_t> sets(cells.size());
  joinNeighbours(cells, sets);

  // Roots are the first cells of regions, so these come in the order of keys.
  CellRegions regions;
  regions.label.resize(cells.size());
  std::vector<std::size_t> region_of_root(cells.size());
  std::vector<std::size_t> sizes;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::size_t root = sets.find(i);
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

} // namespace pcl::sedr
