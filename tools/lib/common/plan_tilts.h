// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/wall_tilts.h>

#include <string>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief The walls that lean of the plan in a file that loadFloorplan() has read. What
 * is wrong with them is a ToolError of one sentence. */
WallTilts planTilts(const std::string& path);

} // namespace tools
} // namespace sedr
} // namespace pcl
