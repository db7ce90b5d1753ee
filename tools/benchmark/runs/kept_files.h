// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "benchmark/figures/scene_truth.h"
#include "run_row.h"

#include "simulator/scan/scan.h"

#include <pcl/sedr_surface/indoor_structure_reconstruction.h>

#include <filesystem>
#include <string>

namespace pcl {
namespace sedr {
namespace benchmark {

/** @brief The files of a run, for a closer look: FOLDER/SCENE_n0.01_s1/scan.pcd,
 * truth.ply, truth.json, structure.pcd, floorplan.json, solid.ply, mesh.ply. What
 * cannot be written is thrown as a std::runtime_error of one sentence. */
class KeptFiles {
public:
  /** @param folder where the run gets a folder; empty: nothing is kept */
  KeptFiles(const std::filesystem::path& folder, const RunRow& row);

  void keepInput(const sim::Scan& scan,
                 const SceneTruth& truth,
                 const std::string& scene) const;

  /** @brief Keeps whatever the chain found, the mesh too if `has_mesh`. */
  void keepResult(const pcl::IndoorStructureReconstruction<pcl::PointXYZ>& chain,
                  bool has_mesh) const;

private:
  std::filesystem::path folder_; ///< of this run; empty: nothing is kept
};

} // namespace benchmark
} // namespace sedr
} // namespace pcl
