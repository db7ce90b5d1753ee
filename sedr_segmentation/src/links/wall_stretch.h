// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../loop/loop_fit.h"

#include <Eigen/Core>

#include <cstddef>

namespace pcl::sedr {

/** @brief A wall across a contour: points within a tolerance of each other. */
struct WallStretch {
  double offset = 0; ///< their mean, to the left of the contour, metres
  std::size_t count = 0;
  double deviation = 0; ///< their root mean square distance from the mean, metres
};

/** @brief Finds the wall at `place` with direction `along`: the densest interval of
 * evidence offsets, with a preference for the expected offset. */
WallStretch wallAcross(const PlanPoints& evidence,
                       const Eigen::Vector2d& place,
                       const Eigen::Vector2d& along,
                       const LoopParameters& parameters);

} // namespace pcl::sedr
