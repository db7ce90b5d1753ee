// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "room_columns.h"

#include <pcl/sedr_filters/point_view.h>

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief The least that is seen of what hangs, and of a wall below it, metres. */
constexpr double least_hanging_run = 0.3;

/** @brief The least length in plan of the front of what hangs, metres. */
constexpr double least_hanging_front = 0.5;

/** @brief What the columns of a grid tell of furniture that hangs on walls. */
class HangingColumns {
public:
  HangingColumns(const CellGrid& grid,
                 const PointView& points,
                 const ColumnTable& columns,
                 const PlanSlab& ceiling,
                 const PlanSlab& floor)
      : room_(grid, columns, ceiling, floor)
      , grid_(grid)
      , points_(points)
      , columns_(columns)
  {}

  double topAt(Cell cell) const { return room_.ceilingAt(cell); }

  /** @brief What hangs in a column: something upright without anything upright below.
   */
  std::optional<ColumnRun> frontAt(Cell cell) const;

  /** @brief What is seen in a column of a wall below what hangs before it: something
   * upright with nothing above. */
  std::optional<ColumnRun> backAt(Cell cell) const;

  /** @brief Whether the lower edges of some fronts are at few heights, as those of
   * cupboards and hoods are, but for one of ten: the edge of what furniture hides of a
   * wall is not level. */
  bool hasLevelEdges(const std::vector<Cell>& region) const;

  /** @brief Whether a straight row of fronts is the head of an opening: the wall goes
   * on in line with it, down to the floor. */
  bool isHead(const std::vector<Cell>& region) const;

  /** @brief Height at which fronts end, below a soffit perhaps: above it, hardly any of
   * their columns holds anything for a voxel's height. */
  double topOf(const std::vector<Cell>& region) const;

  /** @brief Puts points on a wall above what was seen of it in a column, up to a soffit
   * or the ceiling. */
  void continueUpwards(Cell cell, std::vector<Eigen::Vector3f>& points) const;

private:
  /** @brief Where the front in and around a column begins: of a column that holds a few
   * points only, to which noise took them, it is the edge of the one beside it. */
  double edgeAround(Cell cell) const;

  /** @brief Height of what is seen next above a place in and around a column. */
  double nextAbove(Cell cell, double z) const;

  RoomColumns room_;
  const CellGrid& grid_;
  const PointView& points_;
  const ColumnTable& columns_;
};

} // namespace sedr
} // namespace pcl
