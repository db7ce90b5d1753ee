// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sstream>
#include <string>

namespace pcl::sedr {

/** @brief Formats a number with six significant digits for a message: std::to_string()
 * writes 1e-300 as 0.000000 and 1e300 with 301 digits. */
inline std::string
numberText(double value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}

} // namespace pcl::sedr
