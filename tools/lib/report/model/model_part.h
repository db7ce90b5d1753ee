// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "report/report_page.h"
#include "results/result_folder.h"

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <string>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief The model to turn and cut: the folder's model.glb, and the mesh as another
 * glTF, controls and scripts, three.js in them. Where three.js is not found, a sentence
 * that says so; without a mesh and a solid nothing.
 * @param mesh,solid triangles face into the rooms; may be empty */
std::string modelPart(const ResultFolder& folder,
                      const TriangleMesh& mesh,
                      const TriangleMesh& solid,
                      const Floorplan& plan,
                      const PageSettings& settings);

/** @brief What the colours of parts mean. */
std::string labelKey();

/** @brief What the colours of distances mean, up to `range` metres. */
std::string distanceKey(double range);

} // namespace tools
} // namespace sedr
} // namespace pcl
