// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../solver/poisson_level.h"
#include "surface_mending.h"

#include <pcl/sedr_surface/triangle_mesh.h>

#include <vector>

namespace pcl {
namespace sedr {

/** @brief The surface between nodes of values above zero and the others: dual
 * contouring with a vertex in every cell that the surface crosses and two triangles
 * across every edge of the grid that it crosses. Closed and manifold if the values are
 * well composed (makeWellComposed()) and the surface keeps off the rim of the blocks.
 *
 * The crossings of the edges are drawn onto the planes of the samples nearby, and each
 * vertex to where the planes of its cell meet: edges and corners of the surface stay
 * sharp, flat faces flat.
 *
 * @param values at the nodes of `grid`
 * @param samples in blocks of the same grid
 * @param radius cells within which samples tell the plane
 * @param mesh vertices in cells, normals towards values above zero; the same for any
 * number of threads
 * @param vertices what is known of each of them */
void extractDualSurface(const BandGrid& grid,
                        const std::vector<float>& values,
                        const SortedSamples& samples,
                        float radius,
                        unsigned threads,
                        TriangleMesh& mesh,
                        std::vector<SurfaceVertex>& vertices);

} // namespace sedr
} // namespace pcl
