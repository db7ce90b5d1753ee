// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pierced_surfaces.h"

#include <cmath>
#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief A flat surface that rays go through. */
struct Pane {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  double offset = 0;                ///< normal.dot(p) of its points
  std::vector<std::uint32_t> cubes; ///< of PiercedSurfaces, that it is in

  /** @brief Whether a ray ends at least `depth` metres behind the plane of a pane. */
  bool parts(const ScanRay& ray, double depth) const
  {
    const double before = normal.dot(ray.from.cast<double>()) - offset;
    const double behind = normal.dot(ray.to.cast<double>()) - offset;
    return before * behind < 0 && std::abs(behind) >= depth;
  }

  /** @brief Where a ray meets the plane of a pane that parts it. */
  Eigen::Vector3d placeOn(const ScanRay& ray) const
  {
    const Eigen::Vector3d from = ray.from.cast<double>();
    const Eigen::Vector3d whole = ray.to.cast<double>() - from;
    return from + (offset - normal.dot(from)) / normal.dot(whole) * whole;
  }

  /** @brief What a place looks like in it. */
  Eigen::Vector3d imageOf(const Eigen::Vector3d& p) const
  {
    return p - 2 * (normal.dot(p) - offset) * normal;
  }
};

/** @brief The panes of which rays went through several cubes: planes through the points
 * of these cubes.
 * @param pierced of each ray, see PiercedSurfaces */
std::vector<Pane> panesOf(const PiercedSurfaces& surfaces,
                          const std::vector<std::uint32_t>& pierced);

} // namespace pcl::sedr
