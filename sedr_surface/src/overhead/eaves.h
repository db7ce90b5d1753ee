// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ceiling_lines.h"

#include <string>

namespace pcl::sedr {

/** @brief Returns "eaves 1.05" for a wall from which a sloping ceiling rises, if level
 * along the wall; empty for others, and where the ceiling beside it is not shown. The
 * height is above the floor beside the wall. */
std::string
eavesText(const PlanRoom& room, const CeilingLines& ceiling, const PlanElement& wall);

} // namespace pcl::sedr
