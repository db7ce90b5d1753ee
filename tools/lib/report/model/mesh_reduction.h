// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/triangle_mesh.h>

#include <cstddef>

namespace pcl::sedr::tools {

/** @brief Reduces a mesh for display to at most `most` (at least 100) triangles.
 * Vertices of one room in one grid cell are merged into the one where the surface bends
 * most; degenerate triangles are removed. Labels and rooms are kept. The result may not
 * be closed.
 * @return the mesh itself if it is small enough */
TriangleMesh reducedMesh(const TriangleMesh& mesh, std::size_t most);

} // namespace pcl::sedr::tools
