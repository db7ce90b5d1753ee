// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/priors.h>

#include <cstddef>

namespace pcl::sedr {

/** @brief Parameters of the regularisation of a plan. */
struct RegularisationParameters {
  Priors priors;
  /** @brief Maximum contradiction of a relation by measurements, standard deviations.
   */
  double max_sigmas = 3.0;
  double largest_angle = 0.05;        ///< from parallel or perpendicular, radians
  double largest_tangent_angle = 0.2; ///< at a tangent joint, radians
  double farthest = 0.03;             ///< maximum move of a corner, metres
};

/** @brief Result of regularisePlan(): numbers of relations. */
struct RegularisationReport {
  std::size_t parallel = 0; ///< lines made parallel or perpendicular to another
  std::size_t collinear = 0;
  std::size_t tangent = 0; ///< joints
  std::size_t equal_radius = 0;
};

/** @brief Regularises a plan: relations that hold within the measurement uncertainty
 * become exact.
 *
 * Lines become parallel or perpendicular, parts of one wall collinear, smooth joints of
 * arcs tangent, and similar radii equal. Every curve moves by the minimum amount,
 * weighted by its inliers, residual and length. Curves that clearly deviate, such as a
 * wall that is a degree off, do not move. Corners are then the intersections of the
 * curves. A loop that would break is not changed, nor are the curves tied to it.
 * Deterministic. */
RegularisationReport regularisePlan(Floorplan& plan,
                                    const RegularisationParameters& parameters = {});

} // namespace pcl::sedr
