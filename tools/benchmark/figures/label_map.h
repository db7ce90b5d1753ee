// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace pcl::sedr::benchmark {

/** @brief Map from the labels of a file to StructureLabel values. */
using LabelMap = std::map<std::uint32_t, std::uint32_t>;

/** @brief Parses a map such as "7=3,8=3"; an empty text gives an empty map. Throws a
 * tools::ToolError of one sentence that names `option`. */
LabelMap labelMapOf(const std::string& text, const std::string& option);

/** @brief Returns the mapped labels; those that the map does not name are unchanged. */
std::vector<std::uint32_t> mapped(std::vector<std::uint32_t> labels,
                                  const LabelMap& map);

} // namespace pcl::sedr::benchmark
