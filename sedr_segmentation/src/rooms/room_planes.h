// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../air/voxel_columns.h"

#include "sedr_filters/src/grids/cell_set.h"
#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_segmentation/building.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl::sedr {

// The planes of one room: its ceiling and its floor are sheets of any shape, and the
// largest level part of each is its main plane.

/** @brief How the main planes of a room are looked for. */
struct RoomPlaneParameters {
  double tolerance = 0.07; ///< farthest a point is from its plane, metres
  double maximum_tilt = 3 * M_PI / 180.0; ///< radians
  std::uint64_t seed = 1;                 ///< of the random samples
  unsigned threads = 1;
};

/** @brief The height that most of a ceiling has, metres; 0 where there is no point.
 * @param sheet points of the ceiling of one room. O(n). */
double ceilingLevel(const PointView& points, const std::vector<int>& sheet);

/** @brief The lowest height that a fifth of a floor has, metres: platforms are higher.
 * 0 where there is no point.
 * @param sheet points of the floor of one room. O(n). */
double floorLevel(const PointView& points, const std::vector<int>& sheet);

/** @brief The plane of the level part of a sheet around a height.
 *
 * Points within two tolerances of it count, and all where those are fewer than three.
 * @param sheet points of the ceiling or of the floor of one room
 * @param height metres, see ceilingLevel() and floorLevel() */
PlanSlab mainPlane(const PointView& points,
                   const std::vector<int>& sheet,
                   double height,
                   const RoomPlaneParameters& parameters);

/** @brief Those of the points that lie within `tolerance` metres of a plane. */
std::vector<int> pointsOn(const PointView& points,
                          const std::vector<int>& indices,
                          const PlanSlab& plane,
                          double tolerance);

/** @brief Returns the middles of the parts of a cell, cells of a finer grid. */
std::vector<Eigen::Vector2d>
partsOf(Cell cell, const CellGrid& coarse, const CellGrid& fine);

/** @brief Returns the hidden cells of the ceiling of a room: a place for each cell of
 * `grid` which air reaches, but in which nothing of it was seen. Where it may go on in
 * the main plane it does.
 * @param columns of the room; of those whose ceiling was hidden the places are
 * @param coarse grid of the columns, see Building::grid
 * @param seen cells of the ceiling that was seen */
std::vector<Eigen::Vector3f> hiddenCeiling(const std::vector<RoomColumn>& columns,
                                           const CellGrid& coarse,
                                           const CellGrid& grid,
                                           const CellSet& seen,
                                           const PlanSlab& plane);

/** @brief Labels the points of ceilings and floors with their rooms: those near where
 * the air of their column, or of one beside it, ends. Points of walls, which go on
 * below a ceiling, are left out. O(n).
 * @param fine small columns, by which walls are told
 * @param coarse columns of the size of those of the rooms */
void labelSheets(const PointView& points,
                 const std::vector<int>& indices,
                 const VoxelColumns& fine,
                 const VoxelColumns& coarse,
                 unsigned threads,
                 Building& building);

} // namespace pcl::sedr
