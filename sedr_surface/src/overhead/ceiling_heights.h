// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <string>
#include <utility>
#include <vector>

namespace pcl::sedr {

/** @brief Returns the lines in plan along which the ceiling of a room is `height`
 * metres above its floor, as under a roof; exact for planes, to some millimetres below
 * vaults. They end at the borders of details and within 5 cm of walls. Empty if the
 * ceiling is level. */
std::vector<PlanElement> heightLines(const PlanRoom& room, double height);

/** @brief Returns the minimum and maximum height of the ceiling above the floor,
 * metres: at eaves and ridge. */
std::pair<double, double> heightRange(const PlanRoom& room);

/** @brief Returns "eaves 1.05" for a wall from which a sloping ceiling rises, if level
 * along the wall; empty for others. The height is above the floor beside the wall. */
std::string eavesText(const PlanRoom& room, const PlanElement& wall);

} // namespace pcl::sedr
