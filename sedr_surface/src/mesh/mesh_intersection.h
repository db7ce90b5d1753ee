// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/triangle_mesh.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace pcl::sedr {

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

} // namespace pcl::sedr
