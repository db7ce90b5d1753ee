// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "level_columns.h"
#include <pcl/sedr_filters/cell_grid.h>
#include <pcl/sedr_filters/floorplan.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief The marked cells of a set. */
CellSet markedCells(const CellSet& cells, const std::vector<std::uint8_t>& marked);

/** @brief Positions of up to nine cells. */
class CellBlock {
public:
  void add(std::size_t cell) { cells_[size_++] = cell; }

  const std::size_t* begin() const { return cells_.data(); }
  const std::size_t* end() const { return cells_.data() + size_; }

private:
  std::array<std::size_t, 9> cells_{};
  std::size_t size_ = 0;
};

/** @brief Positions of a cell and of the eight around it, those that are in the set. */
CellBlock blockAround(const CellSet& cells, std::size_t at);

/** @brief A stretch [first, last) of the points of a column, columns.all(). */
struct ColumnStretch {
  std::size_t first = 0;
  std::size_t last = 0;
};

/** @brief The points of a cell's column that may lie between `low` and `high`, metres
 * above a plane, all of them and few others: by height, as a plane hardly rises within
 * a cell. */
class StretchesNear {
public:
  StretchesNear(const LevelColumns& columns,
                const PlanSlab& slab,
                double low,
                double high);

  ColumnStretch operator()(std::size_t cell) const;

private:
  const LevelColumns& columns_;
  const PlanSlab& slab_;
  double rise_; ///< of the plane within a cell
  double low_;  ///< upright, not square to the plane
  double high_;
};

/** @brief Heights from `low` to `high`, metres. */
struct HeightRange {
  double low = 0;
  double high = 0;
};

/** @brief The heights at which points of some columns may lie within `reach` metres of
 * a plane. */
HeightRange
heightsNear(const LevelColumns& columns, const PlanSlab& slab, double reach);

/** @brief A stretch [first, last) of candidates sorted by height. */
struct HeightStretch {
  const Candidate* first = nullptr;
  const Candidate* last = nullptr;

  const Candidate* begin() const { return first; }
  const Candidate* end() const { return last; }
};

/** @brief The candidates of some columns that may lie within `reach` metres of a plane,
 * all of them and few others where it is level: by the heights of the plane over these
 * columns. O(log n). */
HeightStretch stretchNear(const LevelColumns& columns,
                          const std::vector<Candidate>& sorted,
                          const PlanSlab& slab,
                          double reach);

/** @brief Marks, of the `asked` cells, the columns of walls: those that go on beyond a
 * plane, with points one and a half to four tolerances above it where `direction` is 1,
 * below it where it is -1, and right beside it, up to 2.25 tolerances, in a block of
 * three by three; below a ceiling in the gap that gapBelow() gives, too: a tall
 * cupboard ends before. O(points of those). */
std::vector<std::uint8_t> columnsThatGoOn(const LevelColumns& columns,
                                          const std::vector<std::uint8_t>& asked,
                                          const PlanSlab& slab,
                                          double direction,
                                          double tolerance);

} // namespace sedr
} // namespace pcl
