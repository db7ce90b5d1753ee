// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

namespace pcl::sedr::tools {

/** @brief Formats a count: "1 room", "3 rooms". */
inline std::string
counted(std::size_t number, const std::string& thing)
{
  return std::to_string(number) + " " + thing + (number == 1 ? "" : "s");
}

} // namespace pcl::sedr::tools
