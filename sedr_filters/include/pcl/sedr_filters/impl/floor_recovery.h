// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/cell_grid.h>
#include <pcl/types.h>

#include <Eigen/Core>

namespace pcl {
namespace sedr {

/** @brief What becomes of the points of a floor under the scope of its rooms. */
struct FloorRecovery {
  pcl::Indices kept;    ///< floor points inside the scope, as they were given
  pcl::Indices removed; ///< the other floor points, non-finite ones included
  pcl::Indices
      sources; ///< points above the cells without floor, cell by cell, then by index
};

/** @brief Compares the cells of a floor with the scope of the rooms, the cells of
 * ceiling and detail together (paper, section 2.3.1). A cell without floor is filled
 * from its ceiling points, or its detail points where there are none. Non-finite points
 * span no cells. O(n log n). */
FloorRecovery recoverFloor(const CellGrid& grid,
                           const PointView& points,
                           const pcl::Indices& floor,
                           const pcl::Indices& ceiling,
                           const pcl::Indices& detail);

/** @brief Mean z of some finite points, metres; NaN of none. */
double meanHeight(const PointView& points, const pcl::Indices& indices);

} // namespace sedr
} // namespace pcl
