// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/triangle_mesh.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief The other vertices of the triangles at a vertex, increasing. */
std::vector<std::uint32_t> neighboursOf(const TriangleMesh& mesh,
                                        std::uint32_t v,
                                        const std::vector<std::uint32_t>& triangles);

/** @brief What is around an edge: its ends may become one vertex of a closed surface
 * where they have just two neighbours in common, each with one left to spare. */
struct EdgeLink {
  std::size_t of_a = 0;              ///< neighbours of one end, the other among them
  std::size_t of_b = 0;              ///< of the other
  std::vector<std::uint32_t> common; ///< of both, increasing
};

/** @brief The link of the edge between `a` and `b`, by the triangles at each. */
EdgeLink linkOf(const TriangleMesh& mesh,
                std::uint32_t a,
                const std::vector<std::uint32_t>& at_a,
                std::uint32_t b,
                const std::vector<std::uint32_t>& at_b);

} // namespace sedr
} // namespace pcl
