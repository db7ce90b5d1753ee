// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_segmentation/building.h>

#include <string>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief "no headroom", "outdoors" or "void". */
const char* nameOf(LeftOutKind kind);

/** @brief A building as JSON: {"format": "sedr-building", "version": 1, "unit": "m",
 * "rooms": [...], "storeys": [...], "doorways": [...], "stairs": [...], "left_out":
 * [...]}. Of the columns of a room those are written whose ceiling was hidden; points
 * are not. */
std::string buildingToJson(const Building& building);

/** @brief Reads what buildingToJson() wrote. What is wrong is a ToolError of one
 * sentence. */
Building loadBuilding(const std::string& path);

} // namespace tools
} // namespace sedr
} // namespace pcl
