// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {
namespace benchmark {

/** @brief What the labels of a file mean here: a StructureLabel for each. */
using LabelMap = std::map<std::uint32_t, std::uint32_t>;

/** @brief Reads a map such as "7=3,8=3"; empty: none. What is wrong with it is a
 * tools::ToolError of one sentence, in which `option` is named. */
LabelMap labelMapOf(const std::string& text, const std::string& option);

/** @brief The meaning of each label; those that the map does not name stay. */
std::vector<std::uint32_t> mapped(std::vector<std::uint32_t> labels,
                                  const LabelMap& map);

} // namespace benchmark
} // namespace sedr
} // namespace pcl
