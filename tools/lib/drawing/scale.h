// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace pcl::sedr::tools {

/** @brief Returns the largest of 1, 2 and 5 times a power of ten that is at most
 * `most`, which must be above 0. */
double roundStep(double most);

/** @brief Formats a round length: "5 m", "20 cm", "2 mm". */
std::string lengthText(double metres);

/** @brief Formats a number with fixed decimals; never "-0". */
std::string fixedText(double value, int digits);

/** @brief Returns the number of decimals required for multiples of `step`. */
int digitsOf(double step);

} // namespace pcl::sedr::tools
