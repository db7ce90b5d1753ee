// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "results/ceiling_rule.h"
#include "results/display_cloud.h"
#include "scan_settings.h"
#include "view_state.h"

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace pcl::sedr::tools {

/** @brief A result to display; each part may be missing. */
struct ViewedResult {
  std::string name; ///< of the folder or file
  DisplayCloud raw;
  DisplayCloud thinned;
  DisplayCloud structure;
  Floorplan plan;
  TriangleMesh mesh;
  TriangleMesh solid;
  std::map<std::uint32_t, std::string> solid_names; ///< by TriangleMesh::elements
  std::vector<std::string> notes; ///< missing parts and reasons, a sentence each

  bool has(Layer layer) const;

  /** @brief Returns the cloud of a layer of points, null for other layers. */
  const DisplayCloud* cloudOf(Layer layer) const;

  /** @brief Returns the mesh of a layer of triangles, null for other layers. */
  const TriangleMesh* meshOf(Layer layer) const;

  /** @brief Returns the box around the model or, without a model, around the clouds;
   * metres. */
  Eigen::AlignedBox3d bounds() const;

  /** @brief Returns the initial layers: the mesh, or the next best one present. */
  LayerSet firstLayers() const;
};

/** @brief Settings for reading a result. */
struct ReadSettings {
  std::string scan;                 ///< raw scan; empty: from report.json
  ScanSettings file;                ///< how a scan that is given itself is read
  std::size_t max_points = 1000000; ///< maximum to show per cloud; 0: all
};

/** @brief Reads a result folder of pcl_sedr, or one file: a floor plan, a mesh, a solid
 * with its element names, or a cloud. A cloud with labels or rooms, as from a stage, is
 * structure; others are raw scans. Throws ToolError if the main file cannot be read;
 * missing parts become notes. */
ViewedResult readResult(const std::string& path, const ReadSettings& settings);

} // namespace pcl::sedr::tools
