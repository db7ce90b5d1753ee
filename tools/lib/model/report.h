// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scan_settings.h"

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/scan_frame.h>
#include <pcl/sedr_surface/floorplan_drawing.h>
#include <pcl/sedr_surface/floorplan_extrusion.h>
#include <pcl/sedr_surface/floorplan_ifc.h>
#include <pcl/sedr_surface/indoor_structure_reconstruction.h>
#include <pcl/sedr_surface/mesh_evaluation.h>
#include <pcl/sedr_surface/plan_review.h>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <optional>
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

/** @brief Input and results of a run of pcl_sedr. */
struct RunRecord {
  std::vector<std::string> inputs; ///< files and folders
  std::size_t points = 0;
  ScanSettings reading; ///< of the scan
  SheetTexts texts;
  std::vector<std::string> files; ///< that the run wrote, names in the folder
  Coverage coverage;
  std::vector<StageReport> stages; ///< reading, the chain, MeshEvaluation, writing
  std::optional<MeshEvaluationResult> figures; ///< empty without a mesh
  Schedules schedules;                         ///< as in model.ifc
  std::vector<PlanWarning> warnings;           ///< of the chain and of what was written
};

/** @brief Returns report.json: verdict, doubts, input, parameters, stages, rooms,
 * coverage, mesh, distances, warnings. Real numbers have seven significant digits. The
 * same input and options give the same text, except for the `seconds` of stages.
 * @param[out] review of the plan */
std::string makeReport(const RunRecord& run,
                       const IndoorStructureReconstruction<pcl::PointXYZ>& chain,
                       PlanReview& review);

/** @brief Returns one line: "4 rooms, 98.8 square metres, 4 closed meshes, 12.3 s". */
std::string summaryOf(const RunRecord& run,
                      const IndoorStructureReconstruction<pcl::PointXYZ>& chain);

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
