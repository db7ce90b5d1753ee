// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <string>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief Writes a mesh without elements as glTF for the page, with one element per
 * room and label. Rooms missing from the plan are put on a separate storey.
 * @param mesh triangles face into the rooms; in glTF they face outwards */
std::string meshToGlb(TriangleMesh mesh, const Floorplan& plan);

} // namespace tools
} // namespace sedr
} // namespace pcl
