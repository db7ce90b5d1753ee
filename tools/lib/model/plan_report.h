// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/scan_frame.h>
#include <pcl/sedr_surface/floorplan_drawing.h>
#include <pcl/sedr_surface/floorplan_extrusion.h>
#include <pcl/sedr_surface/floorplan_ifc.h>
#include <pcl/sedr_surface/plan_review.h>

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief Makes texts of sheets members of the parameters in report.json. */
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(SheetTexts,
                                                title,
                                                client,
                                                project,
                                                date,
                                                drawn_by)

} // namespace pcl::sedr

namespace pcl::sedr::tools {

/** @brief Sets what a report.json tells of a plan: its storeys, rooms, openings and
 * schedules, how much of its walls was measured, warnings and doubts.
 * @return its review */
PlanReview setPlan(nlohmann::ordered_json& report,
                   const Floorplan& plan,
                   const Schedules& schedules,
                   const std::vector<RoomSolidReport>& solids,
                   const std::vector<PlanWarning>& warnings);

/** @brief Returns the warnings that a report.json tells. */
std::vector<PlanWarning> warningsIn(const nlohmann::ordered_json& report);

/** @brief Returns the file of a report. */
std::string textOf(nlohmann::ordered_json report, const Origin& origin);

} // namespace pcl::sedr::tools
