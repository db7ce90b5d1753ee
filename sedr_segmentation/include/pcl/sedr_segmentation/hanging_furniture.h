// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/cell_mask.h>
#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_segmentation/column_table.h>
#include <pcl/sedr_segmentation/horizontal_levels.h>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief What hangs on walls, and what it hides of them. */
struct HangingFurniture {
  std::vector<int> points; ///< of the furniture, increasing
  /** @brief The walls behind it: what was seen of them below, continued upwards. */
  std::vector<Eigen::Vector3f> behind;
};

/** @brief Finds what hides the edge of a ceiling and the wall there, but hangs: wall
 * cupboards and hoods, flush with a soffit or up to the ceiling.
 *
 * A wall stands on the floor, and nothing is seen behind it. What begins between 1.1
 * and 1.8 m above the floor with nothing upright below, and below whose lower edge an
 * upright surface was seen 0.15 to 0.75 m behind it, where no ceiling was seen, hangs
 * before the wall. Heads of doors and niches and soffits begin higher.
 * O(cells of the box), and 1000 cells looked at for each of such a front.
 * @param seen cells in which the ceiling was seen, within a box that has 0.8 m more on
 * each side
 * @param columns all points around them
 * @param threads 0: as many as there are processors */
HangingFurniture hangingFurniture(const CellMask& seen,
                                  const CellGrid& grid,
                                  const PointView& points,
                                  const ColumnTable& columns,
                                  const PlanSlab& ceiling,
                                  const PlanSlab& floor,
                                  unsigned threads = 1);

/** @brief The same below all ceilings of a scan.
 * @param levels classified, with cells and inliers
 * @param cell_size of their cells, metres
 * @param least_height from a floor to its ceiling, metres
 * @param threads 0: as many as there are processors
 * O(n log n) plus the cells of the bounding boxes. */
HangingFurniture hangingFurnitureBelow(const std::vector<Level>& levels,
                                       const PointView& points,
                                       double cell_size,
                                       double least_height,
                                       unsigned threads = 1);

} // namespace sedr
} // namespace pcl
