// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../loop/loop_fit.h"

#include <Eigen/Core>

#include <cstddef>

namespace pcl {
namespace sedr {

/** @brief Points within a tolerance of each other across a contour: a wall. */
struct WallStretch {
  double offset = 0; ///< their mean, to the left of the contour, metres
  std::size_t count = 0;
  double deviation = 0; ///< their root mean square distance from the mean, metres
};

/** @brief The densest stretch of the evidence beside `place`, along a wall that runs in
 * the direction `along` there: most points, those near the expected offset before
 * others. */
WallStretch wallAcross(const PlanPoints& evidence,
                       const Eigen::Vector2d& place,
                       const Eigen::Vector2d& along,
                       const LoopParameters& parameters);

} // namespace sedr
} // namespace pcl
