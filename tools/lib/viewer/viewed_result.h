// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "results/ceiling_rule.h"
#include "results/display_cloud.h"
#include "view_state.h"

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief What there is to look at: each part may be missing. */
struct ViewedResult {
  std::string name; ///< of the folder or file
  DisplayCloud raw;
  DisplayCloud thinned;
  DisplayCloud structure;
  Floorplan plan;
  TriangleMesh mesh;
  TriangleMesh solid;
  std::map<std::uint32_t, std::string> solid_names; ///< by TriangleMesh::elements
  std::vector<std::string> notes; ///< what is missing and why, a sentence each

  bool has(Layer layer) const;

  /** @brief The cloud of a layer of points, null for other layers. */
  const DisplayCloud* cloudOf(Layer layer) const;

  /** @brief The mesh of a layer of triangles, null for other layers. */
  const TriangleMesh* meshOf(Layer layer) const;

  /** @brief Box around the model, where there is none around the clouds; metres. */
  Eigen::AlignedBox3d bounds() const;

  /** @brief The layers to begin with: the mesh, or the next best that there is. */
  LayerSet firstLayers() const;
};

/** @brief What a result is read with. */
struct ReadSettings {
  std::string scan;                  ///< the raw scan; empty: as report.json names it
  std::size_t most_points = 1000000; ///< of a cloud that are shown; 0: all
};

/** @brief Reads the folder that a run of pcl_sedr has left, or one file: a floor
 * plan, a mesh, a solid, which names its elements, or a cloud. That is structure where
 * it has labels or rooms, as a stage's is, and else a raw scan. What cannot be read is
 * a ToolError; a missing part is a note. */
ViewedResult readResult(const std::string& path, const ReadSettings& settings);

} // namespace tools
} // namespace sedr
} // namespace pcl
