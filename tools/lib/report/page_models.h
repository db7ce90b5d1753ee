// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <cstddef>
#include <string>

namespace pcl::sedr::tools {

/** @brief Writes a mesh without elements as binary glTF, with one element per room and
 * label, as solidToGlb() does for solids. Rooms that the plan lacks are put on a storey
 * of their own.
 * @param mesh triangles face out of the rooms */
std::string meshToGlb(TriangleMesh mesh, const Floorplan& plan);

/** @brief Returns a mesh of at most `most` triangles for display: its vertices are
 * clustered room by room in cells of one size (vtkQuadricClustering), so that corners
 * and edges stay. Small meshes are returned as they are. Labels and rooms are kept,
 * elements are not. */
TriangleMesh reducedMesh(const TriangleMesh& mesh, std::size_t most);

} // namespace pcl::sedr::tools
