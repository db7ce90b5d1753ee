// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "direction_grid.h"

#include <pcl/sedr_filters/scan_frame.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace pcl::sedr {

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
