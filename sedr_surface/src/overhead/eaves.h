// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <string>

namespace pcl::sedr {

/** @brief Returns "eaves 1.05" for a wall from which a sloping ceiling rises, if level
 * along the wall; empty for others. The height is above the floor beside the wall. */
std::string eavesText(const PlanRoom& room, const PlanElement& wall);

} // namespace pcl::sedr
