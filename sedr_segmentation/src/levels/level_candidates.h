// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "level_columns.h"
#include <pcl/sedr_filters/cell_grid.h>
#include <pcl/sedr_filters/floorplan.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief Returns the marked cells of a set. */
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

/** @brief Returns the positions of a cell and its eight neighbours in the set. */
CellBlock blockAround(const CellSet& cells, std::size_t at);

/** @brief A range [first, last) of the points of a profile, columns.all(). */
struct ColumnStretch {
  std::size_t first = 0;
  std::size_t last = 0;
};

/** @brief Returns the points of a cell between `low` and `high` metres above a plane,
 * and few others. The selection is by height, as a plane hardly rises within a cell. */
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
  double low_;  ///< vertical, not normal to the plane
  double high_;
};

/** @brief A height interval from `low` to `high`, metres. */
struct HeightRange {
  double low = 0;
  double high = 0;
};

/** @brief Returns the height interval of all points within `reach` metres of a plane.
 */
HeightRange
heightsNear(const LevelColumns& columns, const PlanSlab& slab, double reach);

/** @brief A range [first, last) of candidates sorted by height. */
struct HeightStretch {
  const Candidate* first = nullptr;
  const Candidate* last = nullptr;

  const Candidate* begin() const { return first; }
  const Candidate* end() const { return last; }
};

/** @brief Returns the candidates within `reach` metres of a plane, and few others if it
 * is level. The selection is by the heights of the plane over the grid. O(log n). */
HeightStretch stretchNear(const LevelColumns& columns,
                          const std::vector<Candidate>& sorted,
                          const PlanSlab& slab,
                          double reach);

/** @brief Marks the `asked` cells whose profile continues beyond a plane, as at walls.
 * Such a profile has points 1.5 to 4 tolerances from the plane, above it for
 * `direction` 1, below it for -1. Its block of 3 x 3 cells has points within 2.25
 * tolerances and, below a ceiling, in the gap of gapBelow(), where a tall cupboard has
 * none. O(points of those cells). */
std::vector<std::uint8_t> columnsThatGoOn(const LevelColumns& columns,
                                          const std::vector<std::uint8_t>& asked,
                                          const PlanSlab& slab,
                                          double direction,
                                          double tolerance);

} // namespace pcl::sedr
