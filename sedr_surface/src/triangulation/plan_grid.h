// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>
#include <cstdint>

namespace pcl::sedr {

/** @brief A point in plan in integer grid units, within +-2^29 on either axis. The side
 * of a line on which it lies is computed without rounding. */
struct GridPoint {
  std::int32_t x = 0;
  std::int32_t y = 0;

  bool operator==(const GridPoint& o) const { return x == o.x && y == o.y; }
  bool operator!=(const GridPoint& o) const { return !(*this == o); }
  bool operator<(const GridPoint& o) const { return x != o.x ? x < o.x : y < o.y; }
};

/** @brief Returns twice the signed area of a, b, c in square grid units: positive if c
 * is left of the line from a to b. Exact. */
inline std::int64_t
turn(const GridPoint& a, const GridPoint& b, const GridPoint& c)
{
  const auto difference = [](std::int32_t p, std::int32_t q) {
    return static_cast<std::int64_t>(p) - q;
  };
  return difference(b.x, a.x) * difference(c.y, a.y) -
         difference(b.y, a.y) * difference(c.x, a.x);
}

/** @brief Returns the vector between two grid points, grid units. */
inline Eigen::Vector2d
way(const GridPoint& from, const GridPoint& to)
{
  return Eigen::Vector2d(to.x, to.y) - Eigen::Vector2d(from.x, from.y);
}

/** @brief Returns the distance of two grid points, grid units. */
inline double
distance(const GridPoint& a, const GridPoint& b)
{
  return std::hypot(static_cast<double>(a.x) - b.x, static_cast<double>(a.y) - b.y);
}

/** @brief The grid to which a room's plan is rounded. Its unit is a power of two: at
 * most a micrometre for rooms up to 500 m across, coarser for larger ones. */
class PlanGrid {
public:
  PlanGrid() = default;

  /** @param bounds of all points on the grid, metres; not empty */
  explicit PlanGrid(const Eigen::AlignedBox2d& bounds)
  {
    origin_ = bounds.center().array().round();
    const double reach =
        1 + (bounds.max() - origin_).cwiseMax(origin_ - bounds.min()).maxCoeff();
    constexpr int finest = 24; // 60 nm; finer digits are meaningless
    const int bits =
        std::min(finest, 29 - static_cast<int>(std::ceil(std::log2(reach))));
    unit_ = std::ldexp(1.0, -bits);
  }

  /** @brief Returns the length of one grid unit, metres. */
  double unit() const { return unit_; }

  /** @brief Returns the grid point nearest to a place within the bounds, metres. */
  GridPoint toGrid(const Eigen::Vector2d& p) const
  {
    return {static_cast<std::int32_t>(std::lround((p.x() - origin_.x()) / unit_)),
            static_cast<std::int32_t>(std::lround((p.y() - origin_.y()) / unit_))};
  }

  /** @brief Returns the place of a grid point, metres. */
  Eigen::Vector2d toPlan(const GridPoint& p) const
  {
    return origin_ + unit_ * Eigen::Vector2d(p.x, p.y);
  }

private:
  Eigen::Vector2d origin_ = Eigen::Vector2d::Zero();
  double unit_ = std::ldexp(1.0, -20);
};

} // namespace pcl::sedr
