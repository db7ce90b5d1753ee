// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sedr_filters/src/base/plane_fit.h"
#include <pcl/sedr_filters/floorplan.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace pcl::sedr {

/** @brief A point as seen from a wall: metres along it, above its floor, behind it. */
struct WallPoint {
  double along;
  double up;
  double behind;
};

/** @brief How a straight wall that stands on a floor sees a point. */
inline WallPoint
seenFrom(const PlanElement& wall, const PlanSlab& floor, const Eigen::Vector3f& point)
{
  const Eigen::Vector3d p = point.cast<double>();
  const Eigen::Vector2d way = (wall.end - wall.start).normalized();
  const Eigen::Vector2d to = p.head<2>() - wall.start;
  return {way.dot(to), p.z() - floor.heightAt(p.head<2>()),
          way.y() * to.x() - way.x() * to.y()};
}

/** @brief What was seen of a stretch of wall: the points in every cell of length and
 * height. */
class WallCells {
public:
  /** @brief A stretch along a wall, of one cell's height. Metres; there are no cells
   * where it has no length. */
  WallCells(double left, double right, double cell)
      : WallCells(left, right, 0, cell, cell)
  {}

  WallCells(double left, double right, double low, double high, double cell)
      : left_(left)
      , low_(low)
      , cell_(cell)
      , columns_(partsOf(right - left))
      , rows_(partsOf(high - low))
      , counts_(columns_ * rows_, 0)
  {}

  /** @brief Counts a point; one beside the cells is left out. The last of a row or a
   * column may reach beyond the stretch, and has the points at its end. */
  void add(double along, double up = 0)
  {
    const double column = partAt(along - left_, columns_);
    const double row = partAt(up - low_, rows_);
    if (column >= 0 && row >= 0)
      ++counts_[static_cast<std::size_t>(row * static_cast<double>(columns_) + column)];
  }

  /** @brief Points of each cell, row by row. */
  const std::vector<std::size_t>& counts() const { return counts_; }

  /** @brief Adds what others counted of the same stretch. */
  void add(const WallCells& other)
  {
    for (std::size_t k = 0; k < counts_.size(); ++k)
      counts_[k] += other.counts_[k];
  }

private:
  static constexpr double rounding = 1e-6; ///< of lengths, in cells

  /** @brief Cells that cover a length; what rounding adds to it makes no more. */
  std::size_t partsOf(double length) const
  {
    return static_cast<std::size_t>(
        std::max(0.0, std::ceil(length / cell_ - rounding)));
  }

  /** @brief Returns which of `parts` cells a place is in, -1 beside them. */
  double partAt(double place, std::size_t parts) const
  {
    const double at = place / cell_;
    const auto count = static_cast<double>(parts);
    return at >= 0 && at <= count + rounding ? std::min(std::floor(at), count - 1) : -1;
  }

  double left_;
  double low_;
  double cell_;
  std::size_t columns_;
  std::size_t rows_;
  std::vector<std::size_t> counts_;
};

} // namespace pcl::sedr
