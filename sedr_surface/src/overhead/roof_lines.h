// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <string>

namespace pcl::sedr {

/** @brief Distance from a border at which the ceiling beside it is asked for: loops of
 * facets meet within tolerance only; metres. */
constexpr double beside_border = 0.05;

/** @brief Returns "eaves 1.05" for a wall from which a sloping ceiling rises, if level
 * along the wall; empty for others. The height is above the floor beside the wall. */
std::string eavesText(const PlanRoom& room, const PlanElement& wall);

} // namespace pcl::sedr
