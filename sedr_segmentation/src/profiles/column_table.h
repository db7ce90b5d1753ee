// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sedr_filters/src/grids/cell_mask.h"
#include <pcl/sedr_filters/point_view.h>

#include <cstddef>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief A stretch of a grid column that is occupied without a gap, metres. */
struct ColumnRun {
  float low = 0;
  float high = 0;
};

/** @brief The points of each grid column within a box of cells, sorted by height.
 * Points that are not finite or outside of the box are left out. O(n log n); the same
 * for any number of threads. */
class ColumnTable {
public:
  /** @param threads to make it with, 0: as many as there are processors */
  ColumnTable(const CellGrid& grid,
              const CellBox& box,
              const PointView& points,
              const std::vector<int>& indices,
              unsigned threads = 1);

  /** @brief One point of a column. */
  struct Entry {
    float z;
    int index;
  };

  const Entry* begin(Cell cell) const
  {
    return entries_.data() + (frame_.isInside(cell) ? first_[frame_.indexOf(cell)] : 0);
  }

  const Entry* end(Cell cell) const
  {
    return entries_.data() +
           (frame_.isInside(cell) ? first_[frame_.indexOf(cell) + 1] : 0);
  }

  /** @brief Whether a point of the column lies within [low, high]. */
  bool hasWithin(Cell cell, double low, double high) const;

  /** @brief Share of the `bins` equal parts of [low, high] in which the column or one
   * of its neighbours within `radius` cells holds a point. O(points of these columns
   * there). */
  double share(Cell cell, double low, double high, int bins, int radius) const;

  /** @brief The stretches of the column that gaps of more than `gap` metres part,
   * lowest first. */
  std::vector<ColumnRun> runs(Cell cell, double gap) const;

  /** @brief The same table without the points of some cells. */
  ColumnTable without(const CellMask& cells) const;

  /** @brief The indices of the points in some cells, increasing. */
  std::vector<int> indicesIn(const CellMask& cells) const;

  const CellBox& box() const { return frame_.box(); }

private:
  explicit ColumnTable(const CellBox& box)
      : frame_(box)
  {}

  CellMask frame_; ///< holds the box and numbers the cells
  std::vector<std::size_t> first_;
  std::vector<Entry> entries_;
};

} // namespace sedr
} // namespace pcl
