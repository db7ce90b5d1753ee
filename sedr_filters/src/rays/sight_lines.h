// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/scan_frame.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

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

/** @brief A ray through air from a scanner position to a measured point, metres. */
struct SightLine {
  Eigen::Vector3f from = Eigen::Vector3f::Zero();
  Eigen::Vector3f to = Eigen::Vector3f::Zero();
};

/** @brief The rays of scanners with known positions, as evidence about places. A ray
 * that continues behind a place proves that nothing is there; a ray that ends before it
 * shows that the place was hidden from that position.
 *
 * The rays of each position are sorted by direction, as in a range image. Memory grows
 * with the number of rays and positions. */
class SightLines {
public:
  /** @brief Sorts the rays; non-finite ones are left out. O(n log n) for n rays. */
  explicit SightLines(const std::vector<SightLine>& lines);

  /** @brief Returns the number of rays. */
  std::size_t size() const;

  /** @brief Returns where the scanners stood, each place once. */
  std::vector<Eigen::Vector3f> places() const;

  /** @brief Returns the rays in the levelled frame. */
  SightLines levelled(const Levelling& levelling) const;

  /** @brief Numbers of rays that pass through a place or end before it. */
  struct Crossings {
    std::size_t on = 0;      ///< rays that end within 15 cm of the surface
    std::size_t through = 0; ///< rays that continue behind the place
    std::size_t before = 0;  ///< rays that end before the place
  };

  /** @brief Counts the rays that cross a surface, or would if they were extended,
   * within `radius` metres of a place. Rays that begin within 15 cm of the surface are
   * not counted. O(rays of about that direction) for each position.
   * @param normal unit normal of the surface */
  Crossings across(const Eigen::Vector3d& place,
                   const Eigen::Vector3d& normal,
                   double radius) const;

private:
  /** @brief The rays of one scanner position, by direction. */
  struct Station {
    Eigen::Vector3f from;
    DirectionGrid grid;
    std::vector<std::vector<Eigen::Vector3f>> ends; ///< in each cell
  };

  std::vector<Station> stations_;
};

} // namespace pcl::sedr
