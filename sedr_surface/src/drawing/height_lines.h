// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <utility>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief The lines in plan along which the ceiling of a room is `height` metres above
 * its floor, as under a roof: pieces of straight lines, to a few millimetres. Empty
 * where the ceiling is level. */
std::vector<PlanElement> heightLines(const PlanRoom& room, double height);

/** @brief The least and the greatest height of the ceiling over the floor of a room,
 * metres: at the eaves and at the ridge. */
std::pair<double, double> heightRange(const PlanRoom& room);

} // namespace sedr
} // namespace pcl
