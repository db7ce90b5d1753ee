// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/triangle_mesh.h>

#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief Returns a label or room per vertex: that with the largest area around it, the
 * smallest of equals; 0 for a vertex without triangles.
 * @param values one per triangle: TriangleMesh::labels or rooms */
std::vector<std::uint32_t> vertexValues(const TriangleMesh& mesh,
                                        const std::vector<std::uint32_t>& values);

} // namespace pcl::sedr
