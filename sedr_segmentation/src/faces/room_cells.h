// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "wall_slopes.h"

#include "sedr_filters/src/grids/cell_mask.h"
#include <pcl/sedr_filters/point_view.h>

#include <Eigen/Core>

#include <vector>

namespace pcl::sedr {

/** @brief Metres above the floor of a ceiling whose floor was not seen. */
constexpr double usual_height = 2.4;

/** @brief Returns the cells that hold one of the places. */
CellSet cellsOf(const CellGrid& grid, const std::vector<Eigen::Vector3f>& places);

/** @brief The points of a room, as indices. */
struct RoomPoints {
  std::vector<int> ceiling; ///< of ceilings and what hangs from them, all heights
  std::vector<int> floor;
  std::vector<int> walls;              ///< labelled as wall
  std::vector<int> others;             ///< unlabelled, in and near the room
  std::vector<Eigen::Vector3f> hidden; ///< places of its ceiling that were not seen
};

/** @brief What the cells of the plan tell of a room: where its ceiling was seen, and
 * where a surface reaches up to it. Lengths in metres, z up. */
struct RoomCells {
  double floor = 0;       ///< median height of the floor
  double ceiling = 0;     ///< median height of the ceiling
  CellMask seen;          ///< cells with ceiling, seen or hidden, in a box around them
  std::vector<float> top; ///< of the highest ceiling near each cell of the box
  std::vector<float> low; ///< of the lowest ceiling near it
  std::vector<float> bottom; ///< of the highest floor near it
  CellMask solid;            ///< cells in which a surface reaches up to the ceiling
  CellMask glass;            ///< those of them and of pillars that return few rays
  CellMask riser;            ///< cells of lintels: a surface ends at a lower ceiling
  CellMask pillar; ///< cells of an opaque one that ends at a lower ceiling beside a
                   ///< higher one
  CellMask base;   ///< cells of a surface below the band, such as a sill's
  std::vector<Eigen::Vector2d> wall_points; ///< just below the ceiling, on surfaces
  /** @brief Of the height from floor to ceiling at each of them, the share at which
   * something was seen: little of a bulkhead's, much of a wall's. */
  std::vector<float> wall_shares;
  /** @brief Near what reaches up to a ceiling: x, y, and the height above the floor as
   * a share of the room's. */
  std::vector<Eigen::Vector3f> height_points;
  /** @brief On surfaces of `riser`, and of `base` where none goes on to the ceiling. */
  std::vector<Eigen::Vector2d> part_points;

  /** @brief Returns whether two rooms share more than half a metre of height. */
  bool sharesHeights(const RoomCells& other) const;

  /** @brief Returns those of some cells of this room's box in which it shares more than
   * half a metre of height with another room: with its gap there, else with its usual
   * one. Below a gallery a hall does not meet the room above. */
  CellMask besideRoom(const RoomCells& other, const CellMask& cells) const;
};

/** @brief Limits of the evidence of walls, metres. */
struct RoomCellsParameters {
  double margin = 1.5;    ///< of the box around the seen ceiling
  double band = 0.5;      ///< below the ceiling: walls are looked for in this band
  double rim = 0.06;      ///< nearest to the ceiling, where its noise is
  double bin = 0.07;      ///< height of a bin of the band, above the voxel size
  double below = 0.09;    ///< a surface that ends so far below a ceiling is no wall
  double sill = 1.3;      ///< above the floor: no sill is higher, tall furniture is
  int filled = 5;         ///< bins of a surface that reaches up to the ceiling,
  int filled_of_wall = 3; ///< of one that wall growing has reached
  double local = 0.2;     ///< the ceiling of a cell is the highest within this reach
  double few_hits = 0.35; ///< share of the usual hits below which a surface is glass
  double pane_neighbours = 2; ///< reach in which the usual hits are counted
};

/** @brief Returns where in plan a surface meets the ceiling of a room.
 * @param p a point of the surface
 * @param run its horizontal way for each metre up */
Eigen::Vector2d atCeiling(const Eigen::Vector3d& p,
                          const Eigen::Vector2d& run,
                          const CellGrid& grid,
                          const RoomCells& room);

/** @brief Returns where in plan a point of a wall counts: where its wall meets the
 * ceiling if that is not far above, else where it is. */
Eigen::Vector2d placeInPlan(const Eigen::Vector3d& p,
                            const WallSlopes& slopes,
                            const CellGrid& grid,
                            const RoomCells& room);

/** @brief Gathers the cells of every room. O(points + cells of the boxes).
 * @param slopes of the walls, see placeInPlan() */
std::vector<RoomCells> roomCells(const PointView& points,
                                 const std::vector<RoomPoints>& rooms,
                                 const WallSlopes& slopes,
                                 const CellGrid& grid,
                                 const RoomCellsParameters& parameters,
                                 unsigned threads);

/** @brief Returns the sums of a raster over squares of 2 reach + 1 cells. */
std::vector<float>
boxSums(const CellMask& frame, int reach, const std::vector<float>& values);

/** @brief Marks the solid cells and pillars with few hits of the scan as glass: fewer
 * than a share of those of the walls near them, or of the ceiling before them. An
 * opaque surface returns every ray, a pane one in ten. O(points of the scan).
 * @param indices of the scan's points to use; empty: all
 * @param slopes as for roomCells() */
void findGlass(const PointView& scan,
               const std::vector<int>& indices,
               const WallSlopes& slopes,
               const CellGrid& grid,
               const RoomCellsParameters& parameters,
               unsigned threads,
               std::vector<RoomCells>& rooms);

} // namespace pcl::sedr
