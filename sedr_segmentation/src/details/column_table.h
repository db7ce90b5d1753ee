// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sedr_filters/src/grids/cell_mask.h"
#include <pcl/sedr_filters/point_view.h>

#include <cstddef>
#include <vector>

namespace pcl::sedr {

/** @brief A height interval of a profile without a gap, metres. */
struct ColumnRun {
  float low = 0;
  float high = 0;
};

/** @brief The profiles (points per grid cell, sorted by height) in a box of cells.
 * Points that are not finite or outside the box are left out. O(n log n). */
class ColumnTable {
public:
  ColumnTable(const CellGrid& grid,
              const CellBox& box,
              const PointView& points,
              const std::vector<int>& indices);

  /** @brief A point of a profile. */
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

  /** @brief Returns whether a point of the profile lies within [low, high]. */
  bool hasWithin(Cell cell, double low, double high) const;

  /** @brief Returns the runs of the profile separated by gaps of more than `gap`
   * metres, lowest first. */
  std::vector<ColumnRun> runs(Cell cell, double gap) const;

private:
  CellMask frame_; ///< box and cell numbers
  std::vector<std::size_t> first_;
  std::vector<Entry> entries_;
};

} // namespace pcl::sedr
