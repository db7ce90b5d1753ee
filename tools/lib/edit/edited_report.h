// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace pcl::sedr::tools {

/** @brief Keeps in a report what it tells of rooms and walls that an edit did not
 * touch: their doubts, what the scan shows of them, what of them was hidden and their
 * meshes. Walls get their new numbers. What a room of another shape was doubted for
 * stays, marked as being of the time before.
 * @param report of the plan before; its part of the plan is replaced by setPlan()
 * already
 * @param rooms of the report before
 * @param edits sentences; they are added to those that the report tells */
void carryOver(nlohmann::ordered_json& report,
               const nlohmann::ordered_json& rooms,
               const Floorplan& before,
               const Floorplan& plan,
               const std::vector<std::string>& edits);

} // namespace pcl::sedr::tools
