// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief The greatest of 1, 2 and 5 times a power of ten that is not above `most`,
 * which must be above 0. */
double roundStep(double most);

/** @brief A round length in words: "5 m", "20 cm", "2 mm". */
std::string lengthText(double metres);

/** @brief A number with so many digits after the point; never "-0". */
std::string fixedText(double value, int digits);

/** @brief The digits after the point that multiples of `step` need. */
int digitsOf(double step);

} // namespace tools
} // namespace sedr
} // namespace pcl
