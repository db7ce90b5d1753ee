// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief Returns "eaves 1.05" for a wall from which a sloping ceiling rises, if level
 * along the wall; empty for others. The height is above the floor beside the wall.
 * @param is_given of the main ceiling and each detail: it has no eaves */
std::string eavesText(const PlanRoom& room,
                      const std::vector<bool>& is_given,
                      const PlanElement& wall);

} // namespace pcl::sedr
