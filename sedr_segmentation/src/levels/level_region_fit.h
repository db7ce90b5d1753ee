// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "level_parting.h"

#include "sedr_filters/src/base/plane_fit.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Number, mean and covariance of points: what a plane through them needs. */
struct Moments {
  double count = 0;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();

  /** @brief The moments of the points of both. */
  friend Moments operator+(const Moments& a, const Moments& b)
  {
    const double share = b.count / (a.count + b.count);
    const Eigen::Vector3d between = b.mean - a.mean;
    return {a.count + b.count, a.mean + share * between,
            (1 - share) * a.covariance + share * b.covariance +
                share * (1 - share) * between * between.transpose()};
  }

  /** @brief Mean square of the points' distances from a plane, square metres. */
  double variance(const Eigen::Vector3d& normal, const Eigen::Vector3d& point) const
  {
    const double distance = normal.dot(mean - point);
    return normal.dot(covariance * normal) + distance * distance;
  }

  /** @brief Unit normal, upwards, of the plane that fits the points best. */
  Eigen::Vector3d normal() const;
};

/** @brief A connected region of a level, fitted by itself. */
struct LevelRegion {
  std::vector<std::size_t> cells; ///< positions
  Positions points;               ///< on its own plane
  PlanSlab slab;
  Moments moments;
  std::vector<std::size_t> beyond_steps; ///< numbers of the regions across a step
  double height = 0;     ///< median, over the plane of the level, metres
  double least_step = 0; ///< a plane that misses it by less may be its own, metres
  double variance = 0;   ///< of its points about its own plane, square metres
  double unevenness = 0; ///< that of the surface alone, noise left out
};

/** @brief What is around a level before it is parted. */
struct LevelRelief {
  std::vector<double> heights;     ///< see reliefOf(); NaN for walls
  std::vector<std::uint8_t> edges; ///< see cellsOfSteps()
};

/** @brief The relief up to two tolerances from a level: with what noise puts within one
 * tolerance of it comes the whole of the surface that it belongs to. O(n). */
LevelRelief reliefAround(const LevelColumns& columns,
                         const LevelParameters& parameters,
                         const LevelDraft& draft);

/** @brief The regions of at least `minimum_cells` that walls and steps part, the
 * largest first, each fitted by itself. O(n log n).
 * @param slab the plane of the level */
std::vector<LevelRegion> fittedRegions(const LevelColumns& columns,
                                       const std::vector<Candidate>& candidates,
                                       const LevelRelief& relief,
                                       const PlanSlab& slab,
                                       const LevelParameters& parameters,
                                       std::size_t minimum_cells);

} // namespace sedr
} // namespace pcl
