// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/triangle_mesh.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Pairs of triangles that go through each other or lie upon each other, however
 * the mesh hangs together: a solid has none.
 *
 * @param mesh must be one (TriangleMesh::problem() empty)
 * @param tolerance metres above 0: what reaches less deep is taken for rounding. Of a
 * file of floats, 1e-5 for coordinates up to 100 m
 * @param most pairs to look for
 * @return indices of two triangles each, the lesser first, sorted
 *
 * Triangles are swept along the longest axis of the mesh: some seconds for 200000 small
 * ones. Deterministic. */
std::vector<std::pair<std::uint32_t, std::uint32_t>>
findSelfIntersections(const TriangleMesh& mesh,
                      double tolerance = 1e-6,
                      std::size_t most = 1000);

} // namespace sedr
} // namespace pcl
