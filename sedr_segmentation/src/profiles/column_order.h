// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sedr_filters/src/base/exactness.h"
#include "sedr_filters/src/base/parallel_for.h"
#include <pcl/sedr_filters/cell_grid.h>
#include <pcl/sedr_filters/point_view.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace pcl::sedr {

/** @brief Profile number of a point in no profile. */
constexpr auto no_column = std::numeric_limits<std::uint32_t>::max();

/** @brief Sorts points into profiles (one per cell of a set or box), each from its
 * lowest to its highest point. O(n) if the points are already in this order, as thinned
 * ones mostly are; the result does not depend on the number of threads. */
class ColumnOrder {
public:
  /** @param columns number of profiles
   * @param columnOf returns the profile number of a cell, or no_column; points that are
   * not finite or beyond the grid are in no profile
   * @param threads 0: all processors */
  template <typename ColumnOf>
  ColumnOrder(const CellGrid& grid,
              const PointView& points,
              const std::vector<int>& indices,
              std::size_t columns,
              ColumnOf columnOf,
              unsigned threads)
      : threads_(threads)
      , column_of_(indices.size())
      , first_(columns + 1, 0)
  {
    parallelFor(indices.size(), points_a_block, threads, [&](std::size_t k) {
      const Eigen::Vector3f p = points[static_cast<std::size_t>(indices[k])];
      const bool is_held = std::isfinite(p.z()) && grid.holds(p.x(), p.y());
      column_of_[k] = is_held ? columnOf(grid.at(p.x(), p.y())) : no_column;
    });
    for (const std::uint32_t column : column_of_)
      if (column != no_column)
        ++first_[column + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
  }

  /** @brief Returns the first point of each profile, and the end. */
  const std::vector<std::size_t>& first() const { return first_; }

  /** @brief Returns the points in sorted order.
   * @param make makes the point of indices[k]: `make(k, column)`
   * @param isLower order of the points of a profile */
  template <typename Point, typename Make, typename IsLower>
  std::vector<Point> sorted(Make make, IsLower isLower) const
  {
    std::vector<Point> all(first_.back());
    const std::size_t stretches = resolveThreads(threads_);
    // Each thread collects the points of its own profiles, about the same number per
    // thread.
    const auto firstOf = [&](std::size_t stretch) {
      const std::size_t before = first_.back() * stretch / stretches;
      return static_cast<std::size_t>(
          std::lower_bound(first_.begin(), first_.end(), before) - first_.begin());
    };
    parallelBlocks(stretches, 1, threads_, [&](std::size_t s, std::size_t) {
      const std::size_t begin = firstOf(s);
      const std::size_t end = s + 1 < stretches ? firstOf(s + 1) : first_.size() - 1;
      if (begin >= end)
        return;
      std::vector<std::size_t> next(first_.begin() + static_cast<std::ptrdiff_t>(begin),
                                    first_.begin() + static_cast<std::ptrdiff_t>(end));
      for (std::size_t k = 0; k < column_of_.size(); ++k)
        if (column_of_[k] >= begin && column_of_[k] < end)
          all[next[column_of_[k] - begin]++] = make(k, column_of_[k]);
      for (std::size_t c = begin; c < end; ++c) {
        Point* const column = all.data() + first_[c];
        Point* const end_of_column = all.data() + first_[c + 1];
        if (!std::is_sorted(column, end_of_column, isLower))
          std::sort(column, end_of_column, isLower);
      }
    });
    return all;
  }

private:
  unsigned threads_;
  std::vector<std::uint32_t> column_of_; ///< of each point
  std::vector<std::size_t> first_;
};

} // namespace pcl::sedr
