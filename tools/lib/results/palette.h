// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "colour.h"

#include <string>

namespace pcl::sedr::tools {

/** @brief Returns the colour of a distance from the model (paper, Figure 11): from blue
 * at 0 through green, yellow and orange to red at `range` metres and more; grey for
 * NaN. */
Colour distanceColour(double distance, double range);

/** @brief Formats a distance: "0.3 cm", "4 cm", "1.2 m". */
std::string distanceText(double metres);

/** @brief Formats a colour: "#f0901e". */
std::string hexCode(Colour colour);

} // namespace pcl::sedr::tools
