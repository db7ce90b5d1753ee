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
  static constexpr double margin = 0.03;  ///< metres: noise of the surfaces
  static constexpr int to_wall = 2;       ///< cells beside which points may be a wall's

  /** @param domain cells of the room: points in those at its rim are of walls, and no
   * riser's within it
   * @param points of all that was seen in and near the room; those below `low` or
   * above `high` are left out. O(n). */
  RiserBins(const SheetGrid& grid,
            const std::vector<std::uint8_t>& domain,
            const std::vector<Eigen::Vector3d>& points,
            double low,
            double high);

  /** @brief Returns the share of the bins between two heights, without those of the
   * surfaces themselves, that hold points at the border of two cells; 0 if the step is
   * too low to tell. */
  double share(std::size_t cell, std::size_t next, double low, double high) const;

  /** @brief Checks whether a cell lies at the rim of the room. */
  bool isAtWall(std::size_t cell) const { return is_at_wall_[cell] != 0; }

  /** @brief Checks whether points were seen in a cell between two heights. */
  bool isSeen(std::size_t cell, double low, double high) const;

private:
  double bottom_ = 0;
  double bin_ = 0.05;               ///< metres
  std::vector<std::uint64_t> own_;  ///< of each cell, from the bottom up
  std::vector<std::uint64_t> seen_; ///< in and beside it, of no wall
  std::vector<std::uint8_t> is_at_wall_;
};

} // namespace pcl::sedr
