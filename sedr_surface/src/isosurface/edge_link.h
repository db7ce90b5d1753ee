// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/triangle_mesh.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief Returns the other vertices of the triangles at a vertex, increasing. */
std::vector<std::uint32_t> neighboursOf(const TriangleMesh& mesh,
                                        std::uint32_t v,
                                        const std::vector<std::uint32_t>& triangles);

/** @brief Neighbours of an edge's ends. On a closed surface the edge may collapse if
 * its ends have just two common neighbours, each with one neighbour to spare. */
struct EdgeLink {
  std::size_t of_a = 0;              ///< neighbours of one end, including the other
  std::size_t of_b = 0;              ///< neighbours of the other
  std::vector<std::uint32_t> common; ///< neighbours of both, increasing
};

/** @brief Returns the link of the edge between `a` and `b`, from the triangles at
 * each. */
EdgeLink linkOf(const TriangleMesh& mesh,
                std::uint32_t a,
                const std::vector<std::uint32_t>& at_a,
                std::uint32_t b,
                const std::vector<std::uint32_t>& at_b);

} // namespace pcl::sedr
