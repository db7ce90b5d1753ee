// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "picture.h"

#include <pcl/sedr_segmentation/building.h>

namespace pcl::sedr::tools {

/** @brief Draws the rooms of a building, storey by storey: number and area of each
 * room, its hidden parts darker, doorways, and a histogram of ceiling heights. */
Picture drawRooms(const Building& building);

} // namespace pcl::sedr::tools
