// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/wall_tilts.h>

#include <string>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief Returns the tilted walls in a plan file that loadFloorplan() has read. Throws
 * ToolError if they are invalid. */
WallTilts planTilts(const std::string& path);

} // namespace tools
} // namespace sedr
} // namespace pcl
