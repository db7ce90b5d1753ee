// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "results/display_cloud.h"
#include "results/plan_rules.h"

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <map>
#include <string>
#include <vector>

namespace pcl::sedr::tools {

/** @brief Parts of a result that can be shown, in the order of their keys: scan,
 * structure, mesh, solid, plan, openings. */
extern const std::vector<std::string> layer_names;

/** @brief A result to display. Parts that are missing are absent from the maps. */
struct ViewedResult {
  std::string name;                           ///< of the folder or file
  std::map<std::string, DisplayCloud> clouds; ///< layers "scan" and "structure"
  std::map<std::string, TriangleMesh> meshes; ///< layers "mesh" and "solid"
  Floorplan plan;                             ///< layers "plan" and "openings"
  PlanRules rules;                            ///< of the plan
  std::vector<std::string> notes; ///< missing parts and reasons, a sentence each

  /** @brief Returns whether a layer has something to show. */
  bool has(const std::string& layer) const;

  /** @brief Returns the mesh of a layer, empty if there is none. */
  const TriangleMesh& mesh(const std::string& layer) const;

  /** @brief Returns the box around the model or, without a model, around the clouds;
   * metres. */
  Eigen::AlignedBox3d bounds() const;
};

/** @brief Settings for reading a result. */
struct ReadSettings {
  std::string scan;                 ///< raw scan; empty: from report.json
  std::size_t max_points = 1000000; ///< maximum to show per cloud; 0: all
};

/** @brief Reads a result folder of pcl_sedr, or one file: a floor plan, a mesh, a
 * solid, or a cloud. A cloud with labels or rooms, as from a stage, is structure;
 * others are scans. Throws ToolError if the main file cannot be read; missing parts
 * become notes. */
ViewedResult readResult(const std::string& path, const ReadSettings& settings);

} // namespace pcl::sedr::tools
