// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/indoor_structure_reconstruction.h>
#include <pcl/sedr_surface/mesh_evaluation.h>

#include <cstddef>
#include <string>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief What a run started from. */
struct ReportInput {
  std::string path;
  std::size_t points = 0;
  double unit = 1; ///< length of one unit of the file, metres
};

/** @brief report.json: input, parameters, stages, rooms, mesh, distances, warnings. */
std::string
makeReport(const ReportInput& input,
           const IndoorStructureReconstruction<pcl::PointXYZ>& chain,
           const MeshEvaluationResult& figures);

/** @brief "4 rooms, 98.8 square metres, mesh closed", one line. */
std::string
summaryOf(const IndoorStructureReconstruction<pcl::PointXYZ>& chain);

} // namespace tools
} // namespace sedr
} // namespace pcl
