// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/triangle_mesh.h>

#include <functional>
#include <vector>

namespace pcl::sedr::ifc {

/** @brief Returns the closed body between some triangles of a mesh, none of them
 * vertical, and other heights above or below their vertices: a slab on a ceiling, a
 * soffit below it. Its faces are directed outwards. O(n log n).
 * @param triangles indices; none: an empty mesh
 * @param height_at the other height at a vertex, at least a millimetre away and on the
 * same side everywhere */
TriangleMesh prismOn(const TriangleMesh& mesh,
                     const std::vector<std::size_t>& triangles,
                     const std::function<double(const Eigen::Vector3d&)>& height_at);

/** @brief Returns the indices of all triangles of a mesh. */
std::vector<std::size_t> allTriangles(const TriangleMesh& mesh);

/** @brief Returns a mesh with z relative to a height. */
TriangleMesh lowered(TriangleMesh mesh, double height);

} // namespace pcl::sedr::ifc
