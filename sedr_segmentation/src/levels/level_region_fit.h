// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "level_parting.h"

#include "sedr_filters/src/base/plane_fit.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief Number, mean and covariance of points, sufficient for a plane fit. */
struct Moments {
  double count = 0;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();

  /** @brief Returns the moments of the union of two point sets. */
  friend Moments operator+(const Moments& a, const Moments& b)
  {
    const double share = b.count / (a.count + b.count);
    const Eigen::Vector3d between = b.mean - a.mean;
    return {a.count + b.count, a.mean + share * between,
            (1 - share) * a.covariance + share * b.covariance +
                share * (1 - share) * between * between.transpose()};
  }

  /** @brief Returns the mean square distance of the points from a plane, square metres.
   */
  double variance(const Eigen::Vector3d& normal, const Eigen::Vector3d& point) const
  {
    const double distance = normal.dot(mean - point);
    return normal.dot(covariance * normal) + distance * distance;
  }

  /** @brief Returns the upward unit normal of the least-squares plane. */
  Eigen::Vector3d normal() const;
};

/** @brief A connected region of a level with its own plane. */
struct LevelRegion {
  std::vector<std::size_t> cells; ///< positions
  Positions points;               ///< on its own plane
  PlanSlab slab;
  Moments moments;
  std::vector<std::size_t> beyond_steps; ///< regions on the other side of a step
  double height = 0;     ///< median above the plane of the level, metres
  double min_step = 0;   ///< minimum distance from a plane of another level, metres
  double variance = 0;   ///< of its points around its own plane, square metres
  double unevenness = 0; ///< variance of the surface without noise, square metres
};

/** @brief Relief and step cells of a level before it is split. */
struct LevelRelief {
  std::vector<double> heights;     ///< see reliefOf(); NaN for walls
  std::vector<std::uint8_t> edges; ///< see cellsOfSteps()
};

/** @brief Returns the relief up to two tolerances from a level. Surfaces with noise
 * within one tolerance are thus included completely. O(n). */
LevelRelief reliefAround(const LevelColumns& columns,
                         const LevelParameters& parameters,
                         const LevelDraft& draft);

/** @brief Returns the regions of at least `minimum_cells`, separated by walls and steps
 * and fitted separately, largest first. O(n log n).
 * @param slab the plane of the level */
std::vector<LevelRegion> fittedRegions(const LevelColumns& columns,
                                       const std::vector<Candidate>& candidates,
                                       const LevelRelief& relief,
                                       const PlanSlab& slab,
                                       const LevelParameters& parameters,
                                       std::size_t minimum_cells);

} // namespace pcl::sedr
