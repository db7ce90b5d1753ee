// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/floorplan_drawing.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace pcl::sedr {

/** @brief Returns the loops in which the vertical plane through a line cuts a closed
 * mesh, counter-clockwise around what it encloses. Places are metres along the line
 * from its start, and heights. A corner on the plane counts as beyond it. O(triangles).
 */
std::vector<PlanLoop> cutOf(const TriangleMesh& mesh, const SectionLine& line);

inline Eigen::Vector2d
inPlan(const Eigen::Vector3d& p)
{
  return p.head<2>();
}

/** @brief Returns the outlines of some triangles that face one side, holes clockwise.
 * @param place where a vertex is on a drawing; in plan by default */
std::vector<PlanLoop> outlinesOf(
    const TriangleMesh& mesh,
    const std::vector<std::size_t>& triangles,
    const std::function<Eigen::Vector2d(const Eigen::Vector3d&)>& place = inPlan);

/** @brief Returns the ranges in which a line runs within a loop, metres from its start;
 * it goes on beyond both ends. */
std::vector<std::pair<double, double>> rangesIn(const PlanLoop& loop,
                                                const SectionLine& line);

} // namespace pcl::sedr
