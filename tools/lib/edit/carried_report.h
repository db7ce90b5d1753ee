// SPDX-License-Identifier: BSD-3-Clause
// What of a report holds after its plan was edited.
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/plan_warning.h>

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace pcl::sedr::tools {

/** @brief Returns what was doubted of a plan and still is, and that it was edited.
 *
 * Doubts of walls follow their numbers, and go with walls that were touched. What a
 * room of another shape was doubted for stays, with a note that it is of the time
 * before. What was told of files is left out.
 * @param[in,out] report of the plan before; the edits are added to those it tells
 * @param edits sentences */
std::vector<PlanWarning> carriedWarnings(nlohmann::ordered_json& report,
                                         const Floorplan& before,
                                         const Floorplan& plan,
                                         const std::vector<std::string>& edits);

/** @brief Keeps in a report what it tells of rooms and walls that an edit did not
 * touch: what the scan shows of them, what of them was hidden and their meshes. Walls
 * get their new numbers.
 * @param report of the plan before; its part of the plan is replaced by setPlan()
 * already
 * @param rooms of the report before */
void carryOver(nlohmann::ordered_json& report,
               const nlohmann::ordered_json& rooms,
               const Floorplan& before,
               const Floorplan& plan);

} // namespace pcl::sedr::tools
