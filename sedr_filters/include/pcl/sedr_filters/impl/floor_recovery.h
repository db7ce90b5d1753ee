// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/point_view.h>
#include <pcl/types.h>

#include <Eigen/Core>

namespace pcl::sedr {

/** @brief Floor points inside and outside the scope, and sources of missing cells. */
struct FloorRecovery {
  pcl::Indices kept;    ///< floor points inside the scope, in input order
  pcl::Indices removed; ///< the other floor points, non-finite ones included
  pcl::Indices
      sources; ///< points above the cells without floor, by cell, then by index
};

/** @brief Compares the cells of a floor with the scope of the rooms: the cells of
 * ceiling and details together (paper, section 2.3.1). A cell without floor is filled
 * from its ceiling points, or else its detail points. Non-finite points occupy no
 * cells. O(n log n).
 * @param cell_size metres, above 0 */
FloorRecovery recoverFloor(double cell_size,
                           const PointView& points,
                           const pcl::Indices& floor,
                           const pcl::Indices& ceiling,
                           const pcl::Indices& detail);

/** @brief Returns the mean z of finite points, metres; NaN for none. */
double meanHeight(const PointView& points, const pcl::Indices& indices);

} // namespace pcl::sedr
