// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surface_samples.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief Writes the halo of a block (BandGrid::halo_nodes values). */
using GatherHalo = std::function<void(std::size_t, float*)>;

/** @brief The screened Poisson equation on one grid of a hierarchy.
 *
 * The unknown is a function at the nodes of the blocks along the surface, -1/2 behind
 * the surface and 1/2 in front of it. It minimises, in cells,
 *
 *     sum over edges (difference along the edge - normal field there)^2
 *   + weight * sum over samples area * (value at the sample)^2,
 *
 * which is equation 4 of the paper with the gradient along the grid's edges. The
 * normal field is the sum of the samples' normals, each spread by a quadratic
 * B-spline three cells wide. Values between nodes are trilinear. Values around the
 * blocks are given. */
class PoissonLevel {
public:
  /** @brief Cells around a sample that contain its spread normal and the function's
   * change. */
  static constexpr float margin = 3;

  PoissonLevel() = default;

  /** @brief Makes the level for samples in cells of the finest grid.
   * @param scale of this level's cells, relative to those
   * @param weight of the samples against smoothness
   * @param more further blocks besides those around samples */
  PoissonLevel(const std::vector<SurfaceSample>& samples,
               double scale,
               float weight,
               const std::vector<BandGrid::Key>& more,
               unsigned threads);

  const BandGrid& grid() const { return grid_; }

  const SortedSamples& samples() const { return sorted_; }

  /** @brief Values at the nodes. */
  std::vector<float> values;

  /** @brief Improves the values by conjugate gradients, until the residual is a
   * hundredth of the right-hand side, or for 200 iterations.
   * @param gather writes the halo of a block, including given values around the blocks
   *
   * Sums use blocks of fixed size: the same bits for any number of threads. */
  void solve(const GatherHalo& gather, unsigned threads);

  /** @brief Returns the mean of the values at the samples, weighted by area. */
  double meanAtSamples(unsigned threads) const;

private:
  /** @brief Contribution of a sample to the equations of one block. */
  struct Screen {
    std::uint32_t corner; ///< lowest node of its cell, an index of the halo
    float share[3];       ///< position towards the next node
    float weight;
    float area; ///< zero in blocks other than its own

    /** @brief Returns the function at the sample. */
    float valueIn(const float* halo) const
    {
      float shares[8];
      cornerShares(share, shares);
      float value = 0;
      for (std::size_t c = 0; c < 8; ++c)
        value += shares[c] * halo[corner + corners[c]];
      return value;
    }
  };

  void addBlocks(const std::vector<BandGrid::Key>& more);
  void addScreens(float weight);
  void addNormals(unsigned threads);
  void setDiagonal(unsigned threads);
  void apply(const float* halo, std::size_t b, float* result) const;
  /** @brief Applies the equations to x; returns the scalar product of both. */
  double applyAll(const std::vector<float>& x,
                  std::vector<float>& result,
                  unsigned threads) const;

  BandGrid grid_;
  SortedSamples sorted_;
  std::vector<std::vector<Screen>> screens_; ///< of each block
  std::vector<float> right_;
  std::vector<float> diagonal_;
};

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
