// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_segmentation/building.h>

#include <string>

namespace pcl::sedr::tools {

/** @brief Writes a building as JSON: heights and gaps of rooms, storeys, links, stairs.
 */
std::string buildingToJson(const Building& building);

/** @brief Reads the output of buildingToJson(), but for the gaps. Throws ToolError on
 * failure. */
Building loadBuilding(const std::string& path);

} // namespace pcl::sedr::tools
