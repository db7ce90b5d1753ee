// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/triangle_mesh.h>

#include <cstddef>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief A mesh of at most `most` (at least 100) triangles, for a screen: vertices of
 * one room in one cell of a grid become one, which is where the surface bends most, and
 * triangles that lose their area go. Labels and rooms stay. It need not be closed any
 * more.
 * @return the mesh itself where it is small enough */
TriangleMesh reducedMesh(const TriangleMesh& mesh, std::size_t most);

} // namespace tools
} // namespace sedr
} // namespace pcl
