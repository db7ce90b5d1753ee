// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surface_samples.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief How well a linear system was solved. */
struct SolveReport {
  int iterations = 0;
  double residual = 0; ///< length over that of the right side, both scaled by diagonal
};

/** @brief Writes the halo of a block (BandGrid::halo_nodes values). */
using GatherHalo = std::function<void(std::size_t, float*)>;

/** @brief The screened Poisson equation on one grid of a hierarchy.
 *
 * Unknown is a function that is -1/2 behind the surface and 1/2 before it, at the nodes
 * of the blocks along the surface. It makes least, in cells,
 *
 *     sum over edges (difference along the edge - normal field there)^2
 *   + weight * sum over samples area * (value at the sample)^2,
 *
 * which is equation 4 of the paper with the gradient taken along the edges of the grid.
 * The normal field is the sum of the samples' normals, each smeared by a quadratic
 * B-spline as wide as three cells; values between nodes are trilinear. What lies around
 * the blocks is given. */
class PoissonLevel {
public:
  /** @brief Cells beside a sample in which the smeared normals and the change of the
   * function have room. */
  static constexpr float margin = 3;

  PoissonLevel() = default;

  /** @brief The level for samples in cells of the finest grid.
   * @param scale of this level's cells, in those
   * @param weight of the samples against smoothness
   * @param more blocks wanted besides those around samples */
  PoissonLevel(const std::vector<SurfaceSample>& samples,
               double scale,
               float weight,
               const std::vector<BandGrid::Key>& more,
               unsigned threads);

  const BandGrid& grid() const { return grid_; }

  const SortedSamples& samples() const { return sorted_; }

  /** @brief Values at the nodes. */
  std::vector<float> values;

  /** @brief Improves the values by conjugate gradients, until the residual is
   * `tolerance` times the right side or `max_iterations` are over.
   * @param gather writes the halo of a block, with what is given around the blocks
   *
   * The sums run in blocks of fixed size: the same bits for any number of threads. */
  SolveReport solve(const GatherHalo& gather,
                    double tolerance,
                    int max_iterations,
                    unsigned threads);

  /** @brief Mean of the values at the samples, weighted by their areas. */
  double meanAtSamples(unsigned threads) const;

private:
  /** @brief What a sample adds to the equations of one block. */
  struct Screen {
    std::uint32_t corner; ///< lowest node of its cell, an index of the halo
    float share[3];       ///< of the way to the next node
    float weight;
    float area; ///< zero in the blocks beside its own
  };

  void addBlocks(const std::vector<BandGrid::Key>& more);
  void addScreens(float weight);
  void addNormals(unsigned threads);
  void setDiagonal(unsigned threads);
  void apply(const float* halo, std::size_t b, float* result) const;
  void applyAll(const std::vector<float>& x,
                std::vector<float>& result,
                double& product,
                unsigned threads) const;

  BandGrid grid_;
  SortedSamples sorted_;
  std::vector<Screen> screens_;
  std::vector<std::size_t> screen_starts_;
  std::vector<float> right_;
  std::vector<float> diagonal_;
};

} // namespace sedr
} // namespace pcl
