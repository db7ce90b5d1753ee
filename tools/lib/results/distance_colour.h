// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "colour.h"

#include <string>
#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief The colour of a distance from the model (paper, Figure 11): blue at 0 by
 * green, yellow and orange to red at `range` metres and beyond; grey for NaN. */
Colour distanceColour(double distance, double range);

/** @brief A distance in words: "0.3 cm", "4 cm", "1.2 m". */
std::string distanceText(double metres);

} // namespace tools
} // namespace sedr
} // namespace pcl
