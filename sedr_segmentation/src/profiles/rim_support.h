// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/cell_grid.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/types.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace pcl::sedr {

/** @brief Occupied voxels: cubes in profiles over the cells of a plan. */
class ColumnOccupancy {
public:
  /** @param grid gives the edge of the cubes; its cells must reach all points
   * @param standing indices of finite points */
  ColumnOccupancy(const PointView& points,
                  const CellGrid& grid,
                  const pcl::Indices& standing);

  /** @brief Returns the occupied share, 0 to 1, of the cubes fully between two heights,
   * in the profile of `cell` or its eight neighbours; 1 if no cube fits. */
  double share(Cell cell, double bottom, double top) const;

  const CellGrid& grid() const { return grid_; }

private:
  CellGrid grid_;
  std::vector<std::pair<CellKey, std::int64_t>>
      occupied_; ///< cell and level, increasing
};

/** @brief Returns the seeds of supported rims. Seeds in adjacent cells form a rim. A
 * rim is kept if the mean occupancy of its profiles, from the seeds to `other_height`,
 * is at least `minimum_share`. A wall reaches it despite doors, a lamp does not. */
pcl::Indices supportedSeeds(const PointView& points,
                            const pcl::Indices& seeds,
                            const ColumnOccupancy& occupancy,
                            double other_height,
                            double minimum_share);

} // namespace pcl::sedr
