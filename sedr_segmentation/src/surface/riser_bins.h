// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sheet_grid.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief At which heights points were seen in and beside each cell of a grid: which
 * share of a step a vertical face closes. 64 bins, at least a voxel high. */
class RiserBins {
public:
  static constexpr double min_step = 0.1; ///< metres: lower steps have no bin of
                                          ///< their own

  /** @param points of all that was seen in and near the room; those below `low` or
   * above `high` are left out. O(n). */
  RiserBins(const SheetGrid& grid,
            const std::vector<Eigen::Vector3d>& points,
            double low,
            double high);

  /** @brief Returns the share of the bins between two heights, without those of the
   * surfaces themselves, that hold points at the border of two cells; 0 if the step is
   * too low to tell. */
  double share(std::size_t cell, std::size_t next, double low, double high) const;

  /** @brief Checks whether points were seen in a cell a step or more below a height. */
  bool isBelow(std::size_t cell, double height) const;

private:
  double bottom_ = 0;
  double bin_ = 0.05; ///< metres
  std::vector<std::uint64_t> own_;  ///< of each cell, from the bottom up
  std::vector<std::uint64_t> seen_; ///< in and beside it
};

} // namespace pcl::sedr
