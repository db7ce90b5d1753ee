// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "level_columns.h"
#include <pcl/sedr_filters/cell_grid.h>
#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/priors.h>
#include <pcl/sedr_segmentation/horizontal_plane_detection.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief A horizontal plane of a scan, with all points within the tolerance. */
struct Level {
  PlanSlab slab;
  double height = 0; ///< of the slab in the middle of its cells, metres
  CellSet cells;     ///< cells where the plane was seen, walls left out
  std::vector<int>
      inliers; ///< indices into the points, increasing; see collectInliers()
  LevelKind kind = LevelKind::Other;
  CellSet within;  ///< if not empty, only points of these cells are inliers
  CellSet without; ///< points of these cells are not: they belong to another level
};

/** @brief The columns that levels of these points are looked for in. */
LevelColumns columnsOf(const PointView& points,
                       const std::vector<int>& indices,
                       const LevelParameters& parameters);

/** @brief Finds the horizontal planes of `points[indices]`, lowest first (paper,
 * section 2.3.1).
 *
 * Points of walls are set aside first: those with neighbours both above and below in
 * their own grid column. The density of the others' heights, counted in distinct cells,
 * says where a level is; RANSAC finds the plane there, regions that walls part from
 * each other are parted where their own planes are a step apart, and the search goes on
 * without its points until the best level left is smaller than the minimum area. O(n
 * log n) plus O(n) for each level.
 * @param[out] histogram of all heights before the search, if wanted */
std::vector<Level> findLevels(const PointView& points,
                              const std::vector<int>& indices,
                              const LevelParameters& parameters,
                              HeightHistogram* histogram = nullptr);

/** @brief The same of columns made before, see columnsOf(). */
std::vector<Level> findLevels(const LevelColumns& columns,
                              const LevelParameters& parameters,
                              HeightHistogram* histogram = nullptr);

/** @brief Collects the inliers of classified levels: the points within the tolerance,
 * but for those of columns that go on below a ceiling or above a floor, and of narrow
 * fringes where no point is on the plane itself. So the wall points that reach a slab
 * are not the slab's, and the ceilings of two rooms stay apart at a thin partition. O(n
 * log n). */
void collectInliers(std::vector<Level>& levels,
                    const PointView& points,
                    const std::vector<int>& indices,
                    const LevelParameters& parameters);

/** @brief The same of columns made before, see columnsOf(). */
void collectInliers(std::vector<Level>& levels,
                    const LevelColumns& columns,
                    const LevelParameters& parameters);

/** @brief Decides what each level is. A ceiling is the highest level over most of its
 * cells and has a level at least a room's height below; where only some regions of a
 * level are so, a soffit at the height of shelves elsewhere, it keeps those alone;
 * under each of its regions the lowest level that is seen in a tenth of the region is
 * its floor. All others (table tops, shelves, the ground outside) are neither. */
void classifyLevels(std::vector<Level>& levels, const LevelParameters& parameters);

} // namespace sedr
} // namespace pcl
