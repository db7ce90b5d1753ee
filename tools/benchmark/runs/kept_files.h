// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "benchmark/figures/scene_truth.h"
#include "run_row.h"

#include "simulator/scan/scan.h"

#include <pcl/sedr_surface/indoor_structure_reconstruction.h>

#include <filesystem>
#include <string>

namespace pcl::sedr::benchmark {

/** @brief The files of a run, kept for inspection in FOLDER/SCENE_n0.01_s1: scan.pcd,
 * truth.ply, truth.json, structure.pcd, floorplan.json, solid.ply, mesh.ply. A failed
 * write throws a std::runtime_error of one sentence. */
class KeptFiles {
public:
  /** @param folder parent of the run's folder; empty: no files are kept */
  KeptFiles(const std::filesystem::path& folder, const RunRow& row);

  void keepInput(const sim::Scan& scan,
                 const SceneTruth& truth,
                 const std::string& scene) const;

  /** @brief Writes the results of the chain, including the mesh if `has_mesh`. */
  void keepResult(const pcl::IndoorStructureReconstruction<pcl::PointXYZ>& chain,
                  bool has_mesh) const;

private:
  std::filesystem::path folder_; ///< of this run; empty: no files are kept
};

} // namespace pcl::sedr::benchmark
