// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/triangle_mesh.h>

#include <cstdint>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief A label, or a room, a vertex: that of the largest part of the area around it,
 * of equal ones the smallest; 0 for a vertex without triangles.
 * @param values one a triangle: TriangleMesh::labels or rooms */
std::vector<std::uint32_t> vertexValues(const TriangleMesh& mesh,
                                        const std::vector<std::uint32_t>& values);

} // namespace sedr
} // namespace pcl
