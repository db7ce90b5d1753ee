// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/floorplan_drawing.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <set>
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

/** @brief Finds pairs of triangles that intersect or overlap, whatever their
 * connectivity. A valid solid has none.
 *
 * @param mesh must be valid (TriangleMesh::problem() empty)
 * @param tolerance metres above 0; shallower intersections count as rounding. For
 * floats from files, 1e-5 for coordinates up to 100 m
 * @param most maximum number of pairs
 * @return indices of two triangles each, the lower first, sorted
 *
 * Triangles are swept along the longest axis of the mesh: some seconds for 200000 small
 * ones. Deterministic. */
std::vector<std::pair<std::uint32_t, std::uint32_t>>
findSelfIntersections(const TriangleMesh& mesh,
                      double tolerance = 1e-6,
                      std::size_t most = 1000);

using MeshEdge = std::pair<std::uint32_t, std::uint32_t>; ///< directed

/** @brief Returns the edges of triangles that none of them has in the opposite
 * direction. O(n log n). */
std::set<MeshEdge> rimOf(const std::vector<Triangle>& triangles);

/** @brief Merges vertices at equal positions. Triangles may become degenerate. O(n log
 * n).
 * @return the number of vertices merged into another */
std::size_t weldVertices(TriangleMesh& mesh);

/** @brief Moves vertices at equal positions apart, such as those of two sheets along
 * one edge. Afterwards all positions differ, even in a file of floats, so that readers
 * that weld equal positions join no sheets.
 *
 * All positions are rounded to float. Of several vertices at one position the first
 * stays. Each other one moves 2 % towards the centre of its triangles, or farther if
 * that position is taken. O(n log n).
 * @return the number of vertices moved */
std::size_t partEqualPositions(TriangleMesh& mesh);

/** @brief What keepLargestComponent() removed. */
struct RemovedComponents {
  std::size_t components = 0;
  std::size_t triangles = 0; ///< triangles of these components
};

/** @brief Keeps only the component with the largest area. O(n). */
RemovedComponents keepLargestComponent(TriangleMesh& mesh);

} // namespace pcl::sedr
