// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_segmentation/building.h>

#include <string>

namespace pcl::sedr::tools {

/** @brief Returns "no headroom", "outdoors", "seen in part" and the like. */
const char* nameOf(LeftOutKind kind);

/** @brief Writes a building as JSON: {"format": "sedr-building", "version": 1, "unit":
 * "m", "rooms": [...], "storeys": [...], "doorways": [...], "stairs": [...],
 * "left_out": [...]}. Only the room columns with a hidden ceiling are written; points
 * are omitted. */
std::string buildingToJson(const Building& building);

/** @brief Reads of the output of buildingToJson() what stages use: storeys, doorways,
 * stairs, and of rooms the heights and hidden ceilings. Throws ToolError on failure. */
Building loadBuilding(const std::string& path);

} // namespace pcl::sedr::tools
