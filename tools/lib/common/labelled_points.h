// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tool_cloud.h"

#include <cstdint>
#include <set>

namespace pcl::sedr::tools {

/** @brief Returns the rows with a label. Throws ToolError with `remedy` at its end if
 * there are none. */
pcl::Indices requireLabel(const ToolCloud& cloud,
                          StructureLabel label,
                          const std::string& remedy = "");

/** @brief Returns the numbers of the rooms with a ceiling, label 1; only 0 if its
 * points have no numbers. Throws ToolError if there is no ceiling. */
std::set<std::uint32_t> ceilingRooms(const ToolCloud& cloud);

/** @brief Returns the mean height of all floor points, label 2, for rooms whose floor
 * was not seen. Throws ToolError with `remedy` at its end if none is finite. */
double meanFloorHeight(const ToolCloud& cloud, const std::string& remedy = "");

} // namespace pcl::sedr::tools
