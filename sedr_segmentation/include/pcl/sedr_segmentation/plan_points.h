// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/cell_grid.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Points in plan, found by place: sorted by the cells of a grid. Exact; results
 * come in the order of cells and then of the points, so they are repeatable. */
class PlanPoints {
public:
  /** @param cell_size edge of the cells, metres; about the radius of most queries */
  PlanPoints(std::vector<Eigen::Vector2d> points, double cell_size);

  std::size_t size() const { return points_.size(); }

  const std::vector<Eigen::Vector2d>& all() const { return points_; }

  /** @brief Calls `visit(point)` for every point within `radius` of `p`. */
  template <typename Visitor>
  void forEachWithin(const Eigen::Vector2d& p, double radius, Visitor visit) const
  {
    if (points_.empty() || !grid_.holds(p.x(), p.y()))
      return;
    const Cell low = grid_.at(p.x() - radius, p.y() - radius);
    const Cell high = grid_.at(p.x() + radius, p.y() + radius);
    for (std::int32_t y = low.y; y <= high.y; ++y) {
      const auto from = std::lower_bound(keys_.begin(), keys_.end(), keyOf({low.x, y}));
      const auto to = std::upper_bound(from, keys_.end(), keyOf({high.x, y}));
      for (auto it = from; it != to; ++it) {
        const Eigen::Vector2d& q =
            points_[static_cast<std::size_t>(it - keys_.begin())];
        if ((q - p).squaredNorm() <= radius * radius)
          visit(q);
      }
    }
  }

private:
  CellGrid grid_;
  std::vector<Eigen::Vector2d> points_; ///< sorted by key
  std::vector<CellKey> keys_;
};

} // namespace sedr
} // namespace pcl
