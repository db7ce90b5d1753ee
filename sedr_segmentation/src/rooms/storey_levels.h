// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_segmentation/building.h>

#include <vector>

namespace pcl::sedr {

/** @brief Gives each room its storey, and lists the storeys from the lowest up: rooms
 * whose floors differ by less than `step` metres are of one. O(columns log columns). */
std::vector<PlanStorey> findStoreys(std::vector<BuildingRoom>& rooms, double step);

} // namespace pcl::sedr
