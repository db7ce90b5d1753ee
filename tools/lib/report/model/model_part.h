// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "report/report_page.h"
#include "results/result_folder.h"

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <string>

namespace pcl::sedr::tools {

/** @brief Returns the interactive model: the folder's model.glb, the mesh as another
 * glTF, controls and scripts including three.js. If three.js is not found, a sentence
 * says so. Empty without a mesh and a solid.
 * @param mesh,solid triangles face into the rooms; may be empty */
std::string modelPart(const ResultFolder& folder,
                      const TriangleMesh& mesh,
                      const TriangleMesh& solid,
                      const Floorplan& plan,
                      const PageSettings& settings);

/** @brief Returns the legend of labels. */
std::string labelKey();

/** @brief Returns the legend of distances, up to `range` metres. */
std::string distanceKey(double range);

} // namespace pcl::sedr::tools
