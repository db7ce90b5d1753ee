// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ceiling_lines.h"

#include <utility>
#include <vector>

namespace pcl::sedr {

/** @brief Returns the lines in plan along which the ceiling of a room is `height`
 * metres above its floor, as under a roof. Pieces accurate to a few millimetres, which
 * may go on behind the walls; none along steps that are drawn, and empty if the ceiling
 * is level. */
std::vector<PlanElement>
heightLines(const PlanRoom& room, const CeilingLines& ceiling, double height);

/** @brief Returns the minimum and maximum height of the ceiling above the floor,
 * metres: at eaves and ridge. What the drawing does not show does not count. */
std::pair<double, double> heightRange(const PlanRoom& room,
                                      const CeilingLines& ceiling);

} // namespace pcl::sedr
