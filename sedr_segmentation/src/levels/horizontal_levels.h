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

namespace pcl::sedr {

/** @brief A horizontal plane of a scan with all points within the tolerance. */
struct Level {
  PlanSlab slab;
  double height = 0; ///< of the slab at the centre of its cells, metres
  CellSet cells;     ///< cells where the plane was seen, without walls
  std::vector<int>
      inliers; ///< indices into the points, increasing; see collectInliers()
  LevelKind kind = LevelKind::Other;
  CellSet within; ///< if not empty, only points of these cells are inliers
};

/** @brief Builds the profiles of points for the level detection. */
LevelColumns columnsOf(const PointView& points,
                       const std::vector<int>& indices,
                       const LevelParameters& parameters);

/** @brief Finds the horizontal planes of `points[indices]`, lowest first (paper,
 * section 2.3.1).
 *
 * Points of walls, i.e. with points both above and below them in their profile, are
 * left out first. The height window with the maximum number of occupied cells is the
 * next candidate, and RANSAC fits its plane. The search continues without the level's
 * points down to the minimum area. O(n log n) plus O(n) per level.
 * @param[out] histogram of all heights before the search; optional */
std::vector<Level> findLevels(const PointView& points,
                              const std::vector<int>& indices,
                              const LevelParameters& parameters,
                              HeightHistogram* histogram = nullptr);

/** @brief Overload for existing profiles, see columnsOf(). */
std::vector<Level> findLevels(const LevelColumns& columns,
                              const LevelParameters& parameters,
                              HeightHistogram* histogram = nullptr);

/** @brief Collects the inliers of classified levels: the points within the tolerance.
 * Points of profiles that continue below a ceiling or above a floor are left out, and
 * so are narrow fringes without a point on the plane itself. This excludes wall points
 * near a slab and separates the ceilings of two rooms at a thin partition. O(n log n).
 */
void collectInliers(std::vector<Level>& levels,
                    const PointView& points,
                    const std::vector<int>& indices,
                    const LevelParameters& parameters);

/** @brief Overload for existing profiles, see columnsOf(). */
void collectInliers(std::vector<Level>& levels,
                    const LevelColumns& columns,
                    const LevelParameters& parameters);

/** @brief Classifies each level as ceiling, floor or other. A ceiling is the highest
 * level over most of its cells and has a level at least a room's height below. If only
 * some regions meet this (a soffit at the height of shelves elsewhere), the level keeps
 * only those. The floor of a ceiling region is the lowest level in a tenth of the
 * region. All others (table tops, shelves, the ground outside) are neither. */
void classifyLevels(std::vector<Level>& levels, const LevelParameters& parameters);

} // namespace pcl::sedr
