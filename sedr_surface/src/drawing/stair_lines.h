// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan_lines.h"

#include <vector>

namespace pcl::sedr {

/** @brief Adds the flights of all stairs: up to 1.2 m above the lower room's floor on a
 * plan with that room, whole on one that has the upper room only. What lies below a
 * flight that is drawn is hidden. */
void addStairs(const Floorplan& plan, std::vector<PlanLine>& lines);

} // namespace pcl::sedr
