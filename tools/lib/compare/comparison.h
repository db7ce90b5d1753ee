// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "change.h"

#include <string>
#include <vector>

namespace pcl::sedr::tools {

/** @brief Compares two plans of a building: rooms, walls, columns, slabs and their
 * details, openings, in this order. Both must be in the same frame. Plans that differ
 * by less than the tolerance have no changes. */
std::vector<Change> comparePlans(const Floorplan& before,
                                 const Floorplan& after,
                                 const CompareSettings& settings);

/** @brief Describes a change in a line: "moved partition by 0.30 m (x +0.30, y +0.00),
 * 3.0 m: room_1_wall_3, room_2_wall_1 -> room_1_wall_3, room_2_wall_1"; an opening as
 * "bricked up door, 1.80 m2: opening_3". */
std::string describe(const Change& change);

/** @brief Returns the changes as JSON, with the settings; metres and square metres. */
std::string changesToJson(const std::vector<Change>& changes,
                          const CompareSettings& settings);

} // namespace pcl::sedr::tools
