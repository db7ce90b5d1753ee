// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "poisson_level.h"

#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief The solution on cells along the surface. */
struct PoissonSolution {
  PoissonLevel level;  ///< the finest grid
  double mean = 0;     ///< of its function at the samples
  std::string problem; ///< why there is no solution, or empty
};

/** @brief Solves the screened Poisson equation on a sequence of grids (cascading
 * multigrid), from a few cells across the whole to cells along the surface only. Each
 * grid starts from the solution of the next coarser one, which also gives the values
 * around its blocks. Blocks are placed around the samples, around the surface on the
 * coarser grid, and wherever the surface would leave them.
 * @param samples in cells of the finest grid, like the result
 * @param max_blocks of a grid, in which the surface must be closed */
PoissonSolution solvePoisson(const std::vector<SurfaceSample>& samples,
                             std::size_t max_blocks,
                             unsigned threads);

} // namespace pcl::sedr
