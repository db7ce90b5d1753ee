// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/poisson_solver.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief How screenedPoisson() works. */
struct ScreenedPoissonParameters {
  double cell = 0.04;       ///< edge of the finest cells, metres
  double spacing = 0.05;    ///< typical distance between neighbouring points, metres
  float point_weight = 10;  ///< alpha of equation 4: of the points against smoothness
  double tolerance = 1e-2;  ///< residual over right side at which a grid is solved
  int max_iterations = 200; ///< on each grid
  std::size_t max_nodes = std::size_t(48) << 20; ///< of a grid, about 40 bytes each
  unsigned threads = 1;                          ///< 0: all processors
};

/** @brief What became of a run of screenedPoisson(). */
struct ScreenedPoissonReport {
  double cell = 0;       ///< metres; larger than asked for where nodes ran out
  std::size_t nodes = 0; ///< of the finest grid
  int levels = 0;        ///< grids, each with cells twice those of the one before
  int iterations = 0;    ///< of conjugate gradients on the finest grid
  double residual = 0;   ///< there, over the right side
  bool converged = false;
  double iso_value = 0; ///< mean at the points; -1/2 is behind, 1/2 before them
  int widened = 0;      ///< times that the finest grid was widened
  std::size_t turned_signs =
      0; ///< nodes that changed sign to keep the surface whole and manifold
  std::size_t collapsed_edges = 0; ///< to take out folds and slivers
};

/** @brief Screened Poisson reconstruction (equation 4 of the paper) on cells along the
 * surface: one closed, manifold surface.
 *
 * @param points finite, with unit normals of the free side; at least three
 * @param parameters in range
 * @param mesh the surface, which may have several components; its normals on the side
 * of those of the points; empty on failure
 * @return an empty string, or why there is no surface
 *
 * The same bytes for any number of threads. */
std::string screenedPoisson(const std::vector<OrientedPoint>& points,
                            const ScreenedPoissonParameters& parameters,
                            TriangleMesh& mesh,
                            ScreenedPoissonReport& report);

} // namespace sedr
} // namespace pcl
