// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/cell_grid.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/types.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Which cells of space hold points: cubes in columns over the cells of a plan.
 */
class ColumnOccupancy {
public:
  /** @param grid gives the edge of the cubes; its cells must reach all points
   * @param standing indices of finite points */
  ColumnOccupancy(const PointView& points,
                  const CellGrid& grid,
                  const pcl::Indices& standing);

  /** @brief Share, 0 to 1, of the cubes wholly between two heights that hold a point in
   * the column of `cell` or of its eight neighbours; 1 where no cube fits in between.
   */
  double share(Cell cell, double bottom, double top) const;

  const CellGrid& grid() const { return grid_; }

private:
  CellGrid grid_;
  std::vector<std::pair<CellKey, std::int64_t>>
      occupied_; ///< cell and level, ascending
};

/** @brief Those of `seeds` below or above which something stands. Seeds in touching
 * cells are one rim; a rim is kept if on average its columns, from the seeds to
 * `other_height`, are occupied to at least `minimum_share`: a door interrupts a wall, a
 * lamp is hardly ever there. */
pcl::Indices supportedSeeds(const PointView& points,
                            const pcl::Indices& seeds,
                            const ColumnOccupancy& occupancy,
                            double other_height,
                            double minimum_share);

} // namespace sedr
} // namespace pcl
