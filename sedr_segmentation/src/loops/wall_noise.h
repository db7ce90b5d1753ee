// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "loop_samples.h"

#include <vector>

namespace pcl::sedr {

/** @brief Noise of the places of walls, measured along straight stretches; metres. */
struct WallNoise {
  double sigma = 0.01;      ///< standard deviation of a place from a metre of its wall
  double correlation = 0.1; ///< so long a piece of wall is one independent observation
  double spread = 0.01; ///< standard deviation of such an observation from metres of
                        ///< its wall, which waves: at least sigma
};

/** @brief Measures the noise of walls: the scatter about lines of 1.2 m, how far
 * deviations from them are correlated (their autocorrelation, summed), and the same of
 * longer lines as far as there are enough of them. The errors of scans and walls are
 * red: the longer a wall, the farther it waves. */
WallNoise wallNoise(const std::vector<LoopContour>& contours,
                    const LoopEnergy& energy,
                    double spacing);

} // namespace pcl::sedr
