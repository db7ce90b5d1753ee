// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/impl/cell_grid.h>
#include <pcl/sedr_filters/point_view.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief A set of cells of any extent: a sorted vector of keys and the start of each
 * row. Memory grows with the number of cells, not with their bounding box. */
class CellSet {
public:
  static constexpr std::size_t npos = static_cast<std::size_t>(-1);

  CellSet() = default;

  /** @brief Builds the set from `keys` in any order, repetitions allowed. O(n log n).
   */
  explicit CellSet(std::vector<CellKey> keys);

  /** @brief Builds the set from `keys`, which must be strictly increasing. O(n). */
  static CellSet fromSorted(std::vector<CellKey> keys);

  /** @brief Builds the set of cells that hold a finite point of `points[indices]`. */
  template <typename IndicesT>
  CellSet(const CellGrid& grid, const PointView& points, const IndicesT& indices)
      : CellSet(keysOf(grid, points, indices))
  {}

  std::size_t size() const { return keys_.size(); }

  bool empty() const { return keys_.empty(); }

  /** @brief Returns the position of `cell` in the set, or npos if it is absent. O(log
   * of the gaps of a row). */
  std::size_t find(Cell cell) const;

  bool contains(Cell cell) const { return find(cell) != npos; }

  /** @brief Returns the position of the first cell not before `cell`, size() if none.
   * Neighbours in a row have consecutive positions. As fast as find(). */
  std::size_t firstFrom(Cell cell) const;

  Cell operator[](std::size_t i) const { return cellOf(keys_[i]); }

  const std::vector<CellKey>& keys() const { return keys_; }

private:
  template <typename IndicesT>
  static std::vector<CellKey>
  keysOf(const CellGrid& grid, const PointView& points, const IndicesT& indices)
  {
    std::vector<CellKey> keys;
    keys.reserve(indices.size());
    for (const auto i : indices) {
      const Eigen::Vector3f p = points[static_cast<std::size_t>(i)];
      if (std::isfinite(p.z()) && grid.holds(p.x(), p.y()))
        keys.push_back(keyOf(grid.at(p.x(), p.y())));
    }
    return keys;
  }

  void indexRows();

  std::vector<CellKey> keys_;
  std::vector<std::size_t> row_; ///< first position of every row, then the end
  std::int32_t first_row_ = 0;   ///< y of the first row
};

inline std::size_t
CellSet::find(Cell cell) const
{
  const std::size_t i = firstFrom(cell);
  return i < keys_.size() && keys_[i] == keyOf(cell) ? i : npos;
}

inline std::size_t
CellSet::firstFrom(Cell cell) const
{
  const CellKey key = keyOf(cell);
  const CellKey* const keys = keys_.data();
  std::size_t first = 0;
  std::size_t last = keys_.size();
  if (!row_.empty()) {
    const std::int64_t row = std::int64_t{cell.y} - first_row_;
    if (row < 0)
      return 0;
    if (row + 1 >= static_cast<std::int64_t>(row_.size()))
      return keys_.size();
    first = row_[static_cast<std::size_t>(row)];
    last = row_[static_cast<std::size_t>(row) + 1];
    if (first == last || key <= keys[first])
      return first;
    // A cell's position in its row is at most its distance from the first cell.
    const std::size_t end = last - 1;
    const std::size_t farthest =
        first +
        static_cast<std::size_t>(std::min<CellKey>(key - keys[first], end - first));
    if (keys[farthest] <= key)
      return farthest + (keys[farthest] < key ? 1 : 0);
    // Likewise its position from the end is at most its distance from the last cell.
    first =
        end - static_cast<std::size_t>(std::min<CellKey>(keys[end] - key, end - first));
    last = farthest;
  }
  return static_cast<std::size_t>(std::lower_bound(keys + first, keys + last, key) -
                                  keys);
}

/** @brief Checks whether `asked(position)` is true for any cell of a set within `reach`
 * columns and rows of `middle`, itself included; row by row. */
template <typename Asked>
bool
anyAround(const CellSet& cells, Cell middle, int reach, Asked asked)
{
  for (int dy = -reach; dy <= reach; ++dy) {
    const CellKey last = keyOf({middle.x + reach, middle.y + dy});
    for (std::size_t i = cells.firstFrom({middle.x - reach, middle.y + dy});
         i < cells.size() && cells.keys()[i] <= last; ++i)
      if (asked(i))
        return true;
  }
  return false;
}

CellSet unite(const CellSet& a, const CellSet& b);

CellSet intersect(const CellSet& a, const CellSet& b);

/** @brief Returns the cells of `a` that are not in `b`. */
CellSet subtract(const CellSet& a, const CellSet& b);

/** @brief The connected regions of a set of cells. */
struct CellRegions {
  std::vector<std::size_t> label; ///< region of each cell, 0 .. sizes.size() - 1
  std::vector<std::size_t> sizes; ///< cells, decreasing; equal ones by their first key
};

/** @brief Labels the eight-connected regions (paper, section 2.3.1), largest first. O(n
 * log n). */
CellRegions labelRegions(const CellSet& cells);

} // namespace pcl::sedr
