// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <memory>
#include <vector>

namespace pcl::sedr {

/** @brief A ray through air from a scanner position to a measured point, metres. */
struct SightLine {
  Eigen::Vector3f from = Eigen::Vector3f::Zero();
  Eigen::Vector3f to = Eigen::Vector3f::Zero();
};

/** @brief The rays of scanners with known positions, as evidence about places: a ray
 * that continues behind a place proves that nothing is there. Memory grows with the
 * number of rays and positions. */
class SightLines {
public:
  /** @brief Sorts the rays by their directions; non-finite ones are left out. O(n log
   * n) for n rays. */
  explicit SightLines(const std::vector<SightLine>& lines);

  /** @brief Returns the number of rays. */
  std::size_t size() const;

  /** @brief Returns the rays, by their positions. */
  std::vector<SightLine> lines() const;

  /** @brief Returns where the scanners stood, each place once. */
  std::vector<Eigen::Vector3f> places() const;

  /** @brief Numbers of rays that cross a place of a surface. */
  struct Crossings {
    std::size_t on = 0;      ///< rays that end within 15 cm of the surface
    std::size_t through = 0; ///< rays that continue behind it
  };

  /** @brief Counts the rays that end on a surface, or cross it, within `radius` metres
   * of a place. Rays that begin within 15 cm of the surface are not counted. */
  Crossings across(const Eigen::Vector3d& place,
                   const Eigen::Vector3d& normal,
                   double radius) const;

private:
  struct Station; ///< the rays of one scanner position

  std::vector<std::shared_ptr<const Station>> stations_;
};

} // namespace pcl::sedr
