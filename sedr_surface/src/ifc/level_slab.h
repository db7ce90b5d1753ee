// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <Eigen/Geometry>

#include <functional>
#include <optional>
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

/** @brief Returns the height of a slab over a box if it is level to a millimetre. It is
 * sampled, since a curve may be level at the corners only. */
std::optional<double> levelOf(const PlanSlab& slab, const Eigen::AlignedBox2d& box);

/** @brief Returns whether a room's ceiling or a part of it is not level. */
bool hasSlopingCeiling(const PlanRoom& room);

/** @brief Compares the heights of a detail and a slab at the middle of the detail's
 * box.
 * @return 1 if the detail is above, -1 if below, 0 if at the same height */
int sideOf(const PlanDetail& detail, const PlanSlab& slab);

} // namespace pcl::sedr::ifc
