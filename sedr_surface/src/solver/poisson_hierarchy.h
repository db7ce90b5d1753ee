// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "poisson_level.h"

#include <string>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief How the screened Poisson equation is solved on a hierarchy of grids. */
struct HierarchyOptions {
  float weight = 10;          ///< of the samples against smoothness
  double tolerance = 1e-2;    ///< of the residual, see PoissonLevel::solve()
  int max_iterations = 200;   ///< on each grid
  std::size_t max_blocks = 0; ///< of a grid
  unsigned threads = 1;
};

/** @brief The screened Poisson equation on grids from one of a few cells across the
 * whole, down to one of cells along the surface alone: each solved to its end, with
 * what the next coarser one found as its start and as the values around its blocks
 * (cascading multigrid). On each the blocks lie about the samples, about where the
 * coarser grid saw the surface, and wherever the surface would leave them. */
class PoissonHierarchy {
public:
  /** @brief Solves it.
   * @param samples in cells of the finest grid, in which the result is
   * @return an empty string, or why there is no result */
  std::string solve(const std::vector<SurfaceSample>& samples,
                    const HierarchyOptions& options);

  const PoissonLevel& finest() const { return levels_.front(); }

  std::size_t levels() const { return levels_.size(); }

  /** @brief Mean of the finest grid's function at the samples. */
  double meanAtSamples() const { return mean_; }

  /** @brief On the finest grid, that is. */
  const SolveReport& report() const { return report_; }

  /** @brief How often blocks were added on the finest grid for a surface that left
   * them. */
  int widened() const { return widened_; }

  /** @brief The halo of a finest block; around the blocks with the values of coarser
   * grids. */
  void gather(std::size_t b, float* halo) const { gather(0, b, halo); }

private:
  float
  valueAt(std::size_t level, std::int64_t x, std::int64_t y, std::int64_t z) const;
  void interpolate(std::size_t level, const BandGrid::Block& block, float* halo) const;
  void gather(std::size_t level, std::size_t b, float* halo) const;
  void solveLevel(std::size_t level,
                  const std::vector<SurfaceSample>& samples,
                  std::vector<BandGrid::Key> more,
                  const HierarchyOptions& options);
  void start(std::size_t level, const PoissonLevel& before, unsigned threads);
  std::vector<BandGrid::Key> blocksOfBox(const std::vector<SurfaceSample>& samples,
                                         double scale) const;
  std::vector<BandGrid::Key> blocksAtSurface(std::size_t level) const;
  std::vector<BandGrid::Key> blocksMissing(std::size_t level, float iso) const;

  std::vector<PoissonLevel> levels_;
  SolveReport report_;
  double mean_ = 0;
  int widened_ = 0;
  std::string problem_;
};

} // namespace sedr
} // namespace pcl
