// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../solver/poisson_level.h"
#include "surface_mending.h"

#include <pcl/sedr_surface/triangle_mesh.h>

#include <vector>

namespace pcl::sedr {

/** @brief Extracts the surface between nodes with values above zero and the others by
 * dual contouring. Each cell that the surface crosses has a vertex, each crossed grid
 * edge two triangles. The surface is closed and manifold if the values are well
 * composed (makeWellComposed()) and it stays away from the rim of the blocks.
 *
 * Crossings of edges are projected onto the planes of nearby samples, and each vertex
 * is placed where the planes of its cell meet. Edges and corners stay sharp, flat faces
 * flat.
 *
 * @param values at the nodes of `grid`
 * @param samples in blocks of the same grid
 * @param radius range of samples that contribute to a plane, cells
 * @param mesh vertices in cells, normals towards values above zero; independent of the
 * number of threads
 * @param vertices properties of each vertex */
void extractDualSurface(const BandGrid& grid,
                        const std::vector<float>& values,
                        const SortedSamples& samples,
                        float radius,
                        unsigned threads,
                        TriangleMesh& mesh,
                        std::vector<SurfaceVertex>& vertices);

} // namespace pcl::sedr
