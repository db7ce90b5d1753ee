// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace pcl::sedr {

/** @brief Returns the main directions of lines, modulo 90 degrees, radians: at most
 * `most`, each with at least `least` of the weight of the first. */
std::vector<double> mainAngles(const std::vector<double>& angles,
                               const std::vector<double>& weights,
                               std::size_t most,
                               double least);

} // namespace pcl::sedr
