// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scan_settings.h"

#include <pcl/sedr_surface/floorplan_drawing.h>
#include <pcl/sedr_surface/floorplan_ifc.h>
#include <pcl/sedr_surface/indoor_structure_reconstruction.h>
#include <pcl/sedr_surface/mesh_evaluation.h>
#include <pcl/sedr_surface/plan_review.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

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

} // namespace pcl::sedr::tools
