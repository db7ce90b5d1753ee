// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../solver/poisson_level.h"
#include "../solver/surface_samples.h"

#include <pcl/sedr_surface/triangle_mesh.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief Makes the nodes above zero well composed: where such nodes (or the others)
 * touch only along an edge or at a corner of a cell, one of them changes sign. The
 * faces between nodes of different sign then form a closed manifold surface, and each
 * cell holds at most one piece of it.
 *
 * Nodes with values nearest to zero change first. If that does not converge, nodes
 * above zero change, which terminates. O(blocks) per round. */
void
makeWellComposed(const BandGrid& grid, std::vector<float>& values, unsigned threads);

/** @brief Properties of a surface vertex besides its position. */
struct SurfaceVertex {
  Eigen::Vector3f normal = Eigen::Vector3f::Zero(); ///< mean of the faces that meet
  Eigen::Vector3f line = Eigen::Vector3f::Zero();   ///< direction of its edge
  std::uint8_t sharpness = 0; ///< 0 on a face, 1 at an edge, 2 at a corner
};

/** @brief Removes folds (triangles that face against the normals of their vertices) and
 * slivers from a closed manifold surface by edge collapses, in which the sharper vertex
 * stays in place. The surface stays closed and manifold.
 *
 * @param vertices properties of each vertex of the mesh
 * @param min_height slivers are triangles of less height
 * @param longest maximum length of edges to collapse
 *
 * O(n), in a fixed order. */
void mendSurface(TriangleMesh& mesh,
                 std::vector<SurfaceVertex>& vertices,
                 double min_height,
                 double longest);

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
