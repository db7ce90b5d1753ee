// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/cell_grid.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

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
    forEachIndexWithin(p, radius, [&](std::size_t k) { visit(points_[k]); });
  }

  /** @brief As forEachWithin(), but calls `visit` with the place of the point in all().
   */
  template <typename Visitor>
  void forEachIndexWithin(const Eigen::Vector2d& p, double radius, Visitor visit) const
  {
    visitWithin(p, radius, [&](std::size_t k) {
      visit(k);
      return true;
    });
  }

  /** @brief Calls `visit(point)` for every point in the cells that a box meets: those
   * in it, and some beside it. */
  template <typename Visitor>
  void forEachIn(const Eigen::AlignedBox2d& box, Visitor visit) const
  {
    if (points_.empty() || !grid_.holds(box.min().x(), box.min().y()) ||
        !grid_.holds(box.max().x(), box.max().y()))
      return;
    const Cell low = grid_.at(box.min().x(), box.min().y());
    const Cell high = grid_.at(box.max().x(), box.max().y());
    for (std::int32_t y = low.y; y <= high.y; ++y)
      for (std::size_t i = cells_.firstFrom({low.x, y});
           i < cells_.size() && cells_.keys()[i] <= keyOf({high.x, y}); ++i)
        for (std::size_t k = first_[i]; k < first_[i + 1]; ++k)
          visit(points_[k]);
  }

  /** @brief Whether there is a point within `radius` of `p`. */
  bool hasWithin(const Eigen::Vector2d& p, double radius) const
  {
    return !visitWithin(p, radius, [](std::size_t) { return false; });
  }

private:
  /** @brief Calls `visit` with the place of every point within `radius` of `p` until it
   * returns false.
   * @return whether it never did */
  template <typename Visitor>
  bool visitWithin(const Eigen::Vector2d& p, double radius, Visitor visit) const
  {
    if (points_.empty() || !grid_.holds(p.x(), p.y()))
      return true;
    const Cell low = grid_.at(p.x() - radius, p.y() - radius);
    const Cell high = grid_.at(p.x() + radius, p.y() + radius);
    for (std::int32_t y = low.y; y <= high.y; ++y) {
      // Cells side by side follow one another in the set.
      for (std::size_t i = cells_.firstFrom({low.x, y});
           i < cells_.size() && cells_.keys()[i] <= keyOf({high.x, y}); ++i)
        for (std::size_t k = first_[i]; k < first_[i + 1]; ++k)
          if ((points_[k] - p).squaredNorm() <= radius * radius && !visit(k))
            return false;
    }
    return true;
  }

  CellGrid grid_;
  std::vector<Eigen::Vector2d> points_; ///< sorted by cell
  CellSet cells_;
  std::vector<std::size_t> first_; ///< of the points of each cell, and the end
};

} // namespace sedr
} // namespace pcl
