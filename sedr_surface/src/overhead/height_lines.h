// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <utility>
#include <vector>

namespace pcl::sedr {

/** @brief Returns the lines in plan along which the ceiling of a room is `height`
 * metres above its floor, as under a roof. Pieces accurate to a few millimetres, which
 * may go on behind the walls; none along steps, and empty if the ceiling is level.
 * @param is_given of the main ceiling and each detail: its neighbours go on over it,
 * see CeilingLines */
std::vector<PlanElement>
heightLines(const PlanRoom& room, const std::vector<bool>& is_given, double height);

/** @brief Returns the minimum and maximum height of the ceiling above the floor,
 * metres: at eaves and ridge. */
std::pair<double, double> heightRange(const PlanRoom& room,
                                      const std::vector<bool>& is_given);

} // namespace pcl::sedr
