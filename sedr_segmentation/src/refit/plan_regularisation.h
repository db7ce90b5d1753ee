// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/priors.h>

#include <cstddef>

namespace pcl {
namespace sedr {

/** @brief What makes two curves of a plan related. */
struct RegularisationParameters {
  Priors priors;
  /** @brief A relation that contradicts what was measured by more standard deviations
   * is none. */
  double most_sigmas = 3.0;
  double largest_angle = 0.05;        ///< radians, from parallel or square
  double largest_tangent_angle = 0.2; ///< radians, at a tangent joint
  double farthest = 0.03;             ///< no corner moves farther, metres
};

/** @brief What became of a plan. */
struct RegularisationReport {
  std::size_t parallel = 0; ///< lines that follow the direction of another, or square
  std::size_t collinear = 0;
  std::size_t tangent = 0; ///< joints
  std::size_t equal_radius = 0;
};

/** @brief Makes a plan regular as a draughtsman would: what agrees within what was
 * measured becomes equal.
 *
 * Lines whose directions agree, or are square to each other, within their uncertainty
 * become parallel and perpendicular, parts of one wall collinear, smooth joints of arcs
 * tangent, radii that agree equal. Every curve moves by as little as possible, weighted
 * by its inliers, its residual and its length; one that is clearly otherwise keeps its
 * place, such as a wall that is a degree off. Corners are then where the curves meet. A
 * loop that this would break stays as it is, with all that is tied to it.
 * Deterministic. */
RegularisationReport regularisePlan(Floorplan& plan,
                                    const RegularisationParameters& parameters = {});

} // namespace sedr
} // namespace pcl
