// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace pcl::sedr {

/** @brief The lines on which most walls of a room lie, in two directions that are
 * square to each other. */
class WallLines {
public:
  /** @brief O(n log n) for n cells of walls in plan, times the directions tried.
   * @param cell their edge, metres
   * @param min_length of wall on one line, metres */
  WallLines(const std::vector<Eigen::Vector2d>& walls, double cell, double min_length);

  /** @brief A place along the two directions, metres. */
  Eigen::Vector2d along(const Eigen::Vector2d& place) const
  {
    return {across_.dot(place), Eigen::Vector2d(-across_.y(), across_.x()).dot(place)};
  }

  /** @brief How many edges of cells a line along the walls has per cell of its length:
   * 1 along the grid, 1.4 at 45 degrees to it. */
  double steps() const { return std::abs(across_.x()) + std::abs(across_.y()); }

  /** @brief Number of lines of each direction that lie before a place: two places for
   * which one differs are on different sides of a line. */
  std::array<std::size_t, 2> before(const Eigen::Vector2d& place) const;

private:
  Eigen::Vector2d across_ = Eigen::Vector2d::UnitX();
  std::array<std::vector<double>, 2> lines_; ///< along each direction, increasing
};

} // namespace pcl::sedr
