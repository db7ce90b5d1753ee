// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "loop_samples.h"
#include <pcl/sedr_segmentation/floorplan_fitting.h>

#include <vector>

namespace pcl::sedr {

/** @brief Measures the noise of walls: the scatter about lines of 1.2 m, how far
 * deviations from them are correlated (their autocorrelation, summed), and the same of
 * longer lines as far as there are enough of them. The errors of scans and walls are
 * red: the longer a wall, the farther it waves. */
WallNoise wallNoise(const std::vector<LoopContour>& contours,
                    const LoopEnergy& energy,
                    double spacing);

} // namespace pcl::sedr
