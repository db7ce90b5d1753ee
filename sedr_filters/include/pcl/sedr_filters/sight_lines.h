// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/scan_frame.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief A ray of a scanner: from where it stood to the point that it ended on,
 * metres. What lies between is air. */
struct SightLine {
  Eigen::Vector3f from = Eigen::Vector3f::Zero();
  Eigen::Vector3f to = Eigen::Vector3f::Zero();
};

/** @brief What rays of scanners whose positions are known tell of places: a ray that
 * goes on behind a place proves that there is nothing, one that ends before it, that
 * the place was hidden from there.
 *
 * The rays of each position are kept by direction, as a range image is. Memory grows
 * with the rays and the positions. */
class SightLines {
public:
  /** @brief O(n log n) for n rays; those that are not finite are left out. */
  explicit SightLines(const std::vector<SightLine>& lines);

  /** @brief How many rays there are. */
  std::size_t size() const { return lines_.size(); }

  /** @brief The same in the level frame. */
  SightLines levelled(const Levelling& levelling) const;

  /** @brief How many rays tell something of a place. */
  struct Crossings {
    std::size_t through = 0; ///< go on behind it
    std::size_t before = 0;  ///< end before it
  };

  /** @brief The rays that cross a surface, or would if they went on, within `radius` of
   * a place. Those that begin or end within 15 cm of the surface tell nothing.
   * @param normal of the surface, unit
   * O(rays of about that direction) for each position. */
  Crossings across(const Eigen::Vector3d& place,
                   const Eigen::Vector3d& normal,
                   double radius) const;

private:
  /** @brief The rays of a position, by direction. */
  struct Station {
    Eigen::Vector3f from;
    std::size_t rows = 1;             ///< of cells of directions; of columns twice that
    std::vector<std::uint32_t> first; ///< line of each cell, and the end
  };

  static std::size_t cellOf(const Station& station, const Eigen::Vector3d& direction);

  std::vector<SightLine> lines_; ///< by station and cell
  std::vector<Station> stations_;
};

} // namespace sedr
} // namespace pcl
