// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pcl::sedr {

/** @brief Cells of the directions around a place: rows from straight down to straight
 * up, and twice as many columns around. */
class DirectionGrid {
public:
  /** @brief A grid in which n directions, spread evenly, are `a_cell` in each, but with
   * no cells smaller than 3 degrees. */
  static DirectionGrid forDirections(std::size_t n, double a_cell)
  {
    constexpr double max_rows = 60;
    const double rows = std::sqrt(static_cast<double>(n) / (2 * a_cell));
    return DirectionGrid(static_cast<std::size_t>(std::clamp(rows, 1.0, max_rows)));
  }

  /** @brief How many cells there are. */
  std::size_t size() const { return 2 * rows_ * rows_; }

  /** @param direction unit */
  std::size_t cellOf(const Eigen::Vector3d& direction) const
  {
    return partOf(heightOf(direction), rows_) * 2 * rows_ +
           partOf(turnOf(direction), 2 * rows_);
  }

  /** @brief Calls `see(cell)` for all cells that lead to within `radius` of a place.
   * @param place seen from the middle of the directions */
  template <typename See>
  void forEachAround(const Eigen::Vector3d& place, double radius, See see) const
  {
    const double distance = place.norm();
    const Eigen::Vector3d direction = place / distance;
    // As heights are counted; next to the scanner it is every direction.
    const double reach = distance > radius ? std::asin(radius / distance) / M_PI : 1;
    const double height = heightOf(direction);
    const double level =
        std::cos(M_PI * std::min(std::abs(height - 0.5) + reach, 0.5)); // the least
    const double width = level > 2 * reach ? reach / level : 0.5;       // of a turn
    const auto columns = static_cast<std::ptrdiff_t>(2 * rows_);
    const auto columnAt = [&](double turn) {
      return static_cast<std::ptrdiff_t>(
          std::floor(turn * static_cast<double>(columns)));
    };
    const double turn = turnOf(direction);
    const std::ptrdiff_t first = columnAt(turn - width);
    const std::ptrdiff_t last = std::min(columnAt(turn + width), first + columns - 1);
    const std::size_t last_row = partOf(height + reach, rows_);
    for (std::size_t row = partOf(height - reach, rows_); row <= last_row; ++row)
      for (std::ptrdiff_t c = first; c <= last; ++c)
        see(row * 2 * rows_ +
            static_cast<std::size_t>((c % columns + columns) % columns));
  }

private:
  explicit DirectionGrid(std::size_t rows)
      : rows_(rows)
  {}

  /** @brief Number of a part of [0, 1). */
  static std::size_t partOf(double share, std::size_t parts)
  {
    const double at = std::floor(share * static_cast<double>(parts));
    return static_cast<std::size_t>(
        std::clamp(at, 0.0, static_cast<double>(parts - 1)));
  }

  /** @brief Height of a direction, 0 to 1 from straight down to straight up. */
  static double heightOf(const Eigen::Vector3d& direction)
  {
    return std::asin(std::clamp(direction.z(), -1.0, 1.0)) / M_PI + 0.5;
  }

  /** @brief Where in a turn around z a direction is, 0 to 1. */
  static double turnOf(const Eigen::Vector3d& direction)
  {
    return std::atan2(direction.y(), direction.x()) / (2 * M_PI) + 0.5;
  }

  std::size_t rows_;
};

} // namespace pcl::sedr
