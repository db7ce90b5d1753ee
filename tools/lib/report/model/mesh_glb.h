// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <string>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief A mesh that knows no elements as glTF, for the page: an element a room and
 * label. Rooms that the plan does not have are on a storey of their own.
 * @param mesh triangles face into the rooms; in glTF they look out of them */
std::string meshToGlb(TriangleMesh mesh, const Floorplan& plan);

} // namespace tools
} // namespace sedr
} // namespace pcl
