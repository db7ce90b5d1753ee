// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/priors.h>

#include <Eigen/Core>

#include <vector>

namespace pcl {
namespace sedr {

/** @brief A straight wall, or a line that may be one. */
struct DirectedLine {
  double length = 0; ///< metres
  Eigen::Vector2d direction = Eigen::Vector2d::UnitX();
};

/** @brief Unit directions: of the lines, the longest first, and square to them; at most
 * five pairs. Of short lines, to which noise would lend any direction, only the longest
 * counts, and that only if there are no longer ones. */
std::vector<Eigen::Vector2d> mainDirections(std::vector<DirectedLine> lines,
                                            const Priors& priors = {});

} // namespace sedr
} // namespace pcl
