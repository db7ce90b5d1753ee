// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/point_view.h>

#include <Eigen/Core>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief A cell of a horizontal grid, by column and row. */
struct Cell {
  std::int32_t x = 0;
  std::int32_t y = 0;

  friend bool operator==(Cell a, Cell b) { return a.x == b.x && a.y == b.y; }
};

/** @brief A cell as one number; keys sort row by row. */
using CellKey = std::uint64_t;

inline CellKey
keyOf(Cell cell)
{
  const auto lift = [](std::int32_t v) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(v) + 0x80000000LL);
  };
  return lift(cell.y) << 32 | lift(cell.x);
}

inline Cell
cellOf(CellKey key)
{
  const auto lower = [](std::uint64_t v) {
    return static_cast<std::int32_t>(static_cast<std::int64_t>(v) - 0x80000000LL);
  };
  return {lower(key & 0xffffffffu), lower(key >> 32)};
}

/** @brief The regular grid of the x-y plane (paper, section 2.3.1): square cells, one
 * corner at the origin, so that grids of one cell size always agree. */
class CellGrid {
public:
  /** @param size edge of a cell, metres, > 0 */
  explicit CellGrid(double size)
      : size_(size)
  {}

  double size() const { return size_; }

  /** @brief Whether (x, y) is finite and near enough to the origin for a 32-bit cell.
   */
  bool holds(double x, double y) const
  {
    constexpr double limit = std::numeric_limits<std::int32_t>::max() - 16.0;
    return std::abs(x / size_) < limit && std::abs(y / size_) < limit;
  }

  /** @brief The cell of (x, y), for which holds() must be true: asserted. */
  Cell at(double x, double y) const
  {
    assert(holds(x, y));
    return {floorOf(x / size_), floorOf(y / size_)};
  }

  Eigen::Vector2d centre(Cell cell) const
  {
    return {(cell.x + 0.5) * size_, (cell.y + 0.5) * size_};
  }

private:
  /** @brief std::floor() of a number that fits, without a call. */
  static std::int32_t floorOf(double value)
  {
    const auto whole = static_cast<std::int32_t>(value);
    return whole - (value < whole ? 1 : 0);
  }

  double size_;
};

/** @brief A set of cells anywhere in the plane, whatever its extent: a sorted vector of
 * keys, and where each row of them begins. Memory grows with the number of cells, never
 * with their bounding box. */
class CellSet {
public:
  static constexpr std::size_t npos = static_cast<std::size_t>(-1);

  CellSet() = default;

  /** @brief The cells of `keys`, in any order, repetitions allowed. O(n) where they lie
   * close together, else O(n log n). */
  explicit CellSet(std::vector<CellKey> keys);

  /** @brief The cells of `keys`, which must be increasing, each once. O(n). */
  static CellSet fromSorted(std::vector<CellKey> keys);

  /** @brief The cells that hold at least one finite point of `points[indices]`. */
  template <typename IndicesT>
  CellSet(const CellGrid& grid, const PointView& points, const IndicesT& indices)
      : CellSet(keysOf(grid, points, indices))
  {}

  std::size_t size() const { return keys_.size(); }

  bool empty() const { return keys_.empty(); }

  /** @brief Position of `cell` in the set's order, npos where it is absent. O(log of
   * the gaps of a row). */
  std::size_t find(Cell cell) const;

  bool contains(Cell cell) const { return find(cell) != npos; }

  /** @brief Position of the first cell from `cell` on, size() where there is none:
   * those side by side in a row follow one another. As fast as find(). */
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
  std::vector<std::size_t> row_; ///< first position of every row, and the end
  std::int32_t first_row_ = 0;   ///< its y
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
    // No cell is farther along its row than its distance from the first.
    const std::size_t end = last - 1;
    const std::size_t farthest =
        first +
        static_cast<std::size_t>(std::min<CellKey>(key - keys[first], end - first));
    if (keys[farthest] <= key)
      return farthest + (keys[farthest] < key ? 1 : 0);
    // Nor farther from its end than its distance from the last.
    first =
        end - static_cast<std::size_t>(std::min<CellKey>(keys[end] - key, end - first));
    last = farthest;
  }
  return static_cast<std::size_t>(std::lower_bound(keys + first, keys + last, key) -
                                  keys);
}

/** @brief Whether `asked(position)` is true for any cell of a set up to `reach` columns
 * and rows away from `middle`, itself too; asked row by row. */
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

/** @brief Calls `see(position)` for the cells of a set up to `reach` columns and rows
 * away from `middle`, itself too, row by row. */
template <typename See>
void
forEachAround(const CellSet& cells, Cell middle, int reach, See see)
{
  anyAround(cells, middle, reach, [&](std::size_t i) {
    see(i);
    return false;
  });
}

CellSet unite(const CellSet& a, const CellSet& b);

CellSet intersect(const CellSet& a, const CellSet& b);

/** @brief The cells of `a` that are not in `b`. */
CellSet subtract(const CellSet& a, const CellSet& b);

/** @brief Connected regions of a set of cells. */
struct CellRegions {
  std::vector<std::size_t> label; ///< of each cell of the set, 0 .. sizes.size() - 1
  std::vector<std::size_t>
      sizes; ///< in cells, decreasing; equal ones in the order of the keys
};

/** @brief The eight-connected regions of `cells` (paper, section 2.3.1), largest first.
 * O(n log n). */
CellRegions labelRegions(const CellSet& cells);

/** @brief The cells of each region, largest first. O(n) beyond labelRegions(). */
std::vector<CellSet> connectedRegions(const CellSet& cells);

} // namespace sedr
} // namespace pcl
