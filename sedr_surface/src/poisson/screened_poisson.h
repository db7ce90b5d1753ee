// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/impl/room_samples.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief Parameters of screenedPoisson(). */
struct ScreenedPoissonParameters {
  double cell = 0.04;    ///< edge of the finest cells, metres
  double spacing = 0.05; ///< typical distance between neighbouring points, metres
  std::size_t max_nodes = std::size_t(48) << 20; ///< per grid, about 40 bytes each
  unsigned threads = 1;                          ///< 0: all processors
};

/** @brief Runs screened Poisson reconstruction (equation 4 of the paper) on cells along
 * the surface: one closed, manifold surface.
 *
 * @param points finite, with unit normals towards free space; at least three
 * @param parameters in range; the cell becomes larger if there would be too many nodes
 * @param mesh the surface, possibly of several components, its normals on the side of
 * those of the points; empty on failure
 * @return an empty string, or why there is no surface
 *
 * The same bytes for any number of threads. */
std::string screenedPoisson(const std::vector<OrientedPoint>& points,
                            ScreenedPoissonParameters& parameters,
                            TriangleMesh& mesh);

} // namespace pcl::sedr
