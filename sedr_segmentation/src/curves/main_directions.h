// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/priors.h>

#include <Eigen/Core>

#include <vector>

namespace pcl::sedr {

/** @brief A straight wall or a candidate line of one. */
struct DirectedLine {
  double length = 0; ///< metres
  Eigen::Vector2d direction = Eigen::Vector2d::UnitX();
};

/** @brief Returns the distinct unit directions of the lines, the longest first, each
 * followed by its perpendicular; at most five pairs. Short lines have unreliable
 * directions: only the longest is used, and only if there are no long lines. */
std::vector<Eigen::Vector2d> mainDirections(std::vector<DirectedLine> lines,
                                            const Priors& priors = {});

} // namespace pcl::sedr
