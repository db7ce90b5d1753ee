// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sedr_filters/src/grids/cell_set.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief Spatial index of points in plan, sorted by the cells of a grid. Queries are
 * exact; results are ordered by cell and then by point, so they are repeatable. */
class PlanPoints {
public:
  /** @param cell_size edge of the cells, metres; ideally about the usual query radius
   */
  PlanPoints(const std::vector<Eigen::Vector2d>& points, double cell_size);

  std::size_t size() const { return points_.size(); }

  const std::vector<Eigen::Vector2d>& all() const { return points_; }

  /** @brief Returns which of the points given to the constructor is point `k` of all().
   */
  std::size_t given(std::size_t k) const { return given_[k]; }

  /** @brief Calls `visit(point)` for every point within `radius` of `p`. */
  template <typename Visitor>
  void forEachWithin(const Eigen::Vector2d& p, double radius, Visitor visit) const
  {
    forEachIndexWithin(p, radius, [&](std::size_t k) { visit(points_[k]); });
  }

  /** @brief Calls `visit` with the index in all() of each point within `radius` of `p`.
   */
  template <typename Visitor>
  void forEachIndexWithin(const Eigen::Vector2d& p, double radius, Visitor visit) const
  {
    if (points_.empty() || !grid_.holds(p.x(), p.y()))
      return;
    const Cell low = grid_.at(p.x() - radius, p.y() - radius);
    const Cell high = grid_.at(p.x() + radius, p.y() + radius);
    for (std::int32_t y = low.y; y <= high.y; ++y) {
      // Adjacent cells of a row are consecutive in the set.
      for (std::size_t i = cells_.firstFrom({low.x, y});
           i < cells_.size() && cells_.keys()[i] <= keyOf({high.x, y}); ++i)
        for (std::size_t k = first_[i]; k < first_[i + 1]; ++k)
          if ((points_[k] - p).squaredNorm() <= radius * radius)
            visit(k);
    }
  }

private:
  CellGrid grid_;
  std::vector<Eigen::Vector2d> points_; ///< sorted by cell
  std::vector<std::uint32_t> given_;
  CellSet cells_;
  std::vector<std::size_t> first_; ///< first point of each cell, and the end
};

} // namespace pcl::sedr
