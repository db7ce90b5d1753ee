// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "poisson_level.h"

#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief Options of solving the screened Poisson equation on a hierarchy of grids. */
struct HierarchyOptions {
  float weight = 10;          ///< of the samples against smoothness
  double tolerance = 1e-2;    ///< of the residual, see PoissonLevel::solve()
  int max_iterations = 200;   ///< on each grid
  std::size_t max_blocks = 0; ///< per grid
  unsigned threads = 1;
};

/** @brief Solves the screened Poisson equation on a sequence of grids (cascading
 * multigrid), from a few cells across the whole to cells along the surface only. Each
 * grid starts from the solution of the next coarser one, which also gives the values
 * around its blocks. Blocks are placed around the samples, around the surface on the
 * coarser grid, and wherever the surface would leave them. */
class PoissonHierarchy {
public:
  /** @brief Solves the equation.
   * @param samples in cells of the finest grid, like the result
   * @return an empty string, or why there is no result */
  std::string solve(const std::vector<SurfaceSample>& samples,
                    const HierarchyOptions& options);

  const PoissonLevel& finest() const { return levels_.front(); }

  std::size_t levels() const { return levels_.size(); }

  /** @brief Returns the mean of the finest grid's function at the samples. */
  double meanAtSamples() const { return mean_; }

  /** @brief Returns the report of the finest grid. */
  const SolveReport& report() const { return report_; }

  /** @brief Returns how often the finest grid was extended because the surface left
   * it. */
  int widened() const { return widened_; }

  /** @brief Fills the halo of a block of the finest grid; outside its blocks with
   * values of coarser grids. */
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

} // namespace pcl::sedr
