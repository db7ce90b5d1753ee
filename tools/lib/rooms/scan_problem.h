// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tool_cloud.h"

#include "sedr_segmentation/src/scan/scan_check.h"

#include <string>

namespace pcl::sedr::tools {

/** @brief Throws ToolError unless the file is a scan of rooms in metres. */
void checkScan(const ToolCloud& cloud);

/** @brief Throws ToolError if an axis other than z seems to be up, or the scan is
 * inclined, unless z is trusted.
 * @param missing why no rooms were found along z; thrown in any case if not empty
 * @param found_area of the rooms found along z, square metres */
void checkUp(const ToolCloud& cloud,
             bool trust_up,
             RoomsAlongZ rooms = RoomsAlongZ::NotLookedFor,
             double found_area = 0,
             const std::string& missing = {});

} // namespace pcl::sedr::tools
