// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tool_cloud.h"

#include <cstdint>
#include <set>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief The rows with this label. Where there are none, a ToolError that says so,
 * with `remedy` at its end. */
pcl::Indices requireLabel(const ToolCloud& cloud,
                          StructureLabel label,
                          const std::string& remedy = "");

/** @brief Numbers of the rooms that have a ceiling, label 1; 0 alone if none of its
 * points has a number. No ceiling at all is a ToolError. */
std::set<std::uint32_t> ceilingRooms(const ToolCloud& cloud);

/** @brief Mean height of all floor points, label 2: for rooms whose own floor was not
 * seen. No finite one is a ToolError, with `remedy` at its end. */
double meanFloorHeight(const ToolCloud& cloud, const std::string& remedy = "");

} // namespace tools
} // namespace sedr
} // namespace pcl
