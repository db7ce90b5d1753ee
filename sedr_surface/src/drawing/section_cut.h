// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_surface/floorplan_drawing.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <Eigen/Core>

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace pcl::sedr {

/** @brief Returns the loops in which the vertical plane through a line cuts a closed
 * mesh, counter-clockwise around what it encloses. Places are metres along the line
 * from its start, and heights. A corner on the plane counts as beyond it. O(triangles).
 */
std::vector<PlanLoop> cutOf(const TriangleMesh& mesh, const SectionLine& line);

/** @brief Returns the outlines of some triangles that face one side, holes clockwise.
 * @param place where a vertex is on the drawing */
std::vector<PlanLoop>
outlinesOf(const TriangleMesh& mesh,
           const std::vector<std::size_t>& triangles,
           const std::function<Eigen::Vector2d(const Eigen::Vector3d&)>& place);

/** @brief Returns the ranges in which a line runs within a loop, metres from its start;
 * it goes on beyond both ends. */
std::vector<std::pair<double, double>> rangesIn(const PlanLoop& loop,
                                                const SectionLine& line);

} // namespace pcl::sedr
