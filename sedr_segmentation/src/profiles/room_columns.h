// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ceiling_gap.h"
#include "column_table.h"
#include <pcl/sedr_filters/floorplan.h>

namespace pcl::sedr {

/** @brief Queries on the profiles of a grid between the floor and the ceiling of a
 * room. The constructor's arguments must outlive it. */
class RoomColumns {
public:
  RoomColumns(const CellGrid& grid,
              const ColumnTable& columns,
              const PlanSlab& ceiling,
              const PlanSlab& floor)
      : grid_(grid)
      , columns_(columns)
      , ceiling_(ceiling)
      , floor_(floor)
  {}

  const CellGrid& grid() const { return grid_; }

  const ColumnTable& table() const { return columns_; }

  double floorAt(Cell cell) const { return floor_.heightAt(grid_.centre(cell)); }

  double ceilingAt(Cell cell) const { return ceiling_.heightAt(grid_.centre(cell)); }

  /** @brief Returns the height midway between the floor and `top`. */
  double middleBelow(Cell cell, double top) const { return (floorAt(cell) + top) / 2; }

  /** @brief Returns the height of the highest point within `reach` cells, at most the
   * ceiling's; the floor's height if there is none. It may be that of a soffit. */
  double topAround(Cell cell, int reach) const;

  /** @brief Returns the occupied share of six height bins in the upper half below
   * `top`, without the top `below` metres, of the profiles within `radius` cells. */
  double upperShare(Cell cell, double top, double below, int radius) const;

  /** @brief Returns whether the profile or a neighbour reaches a ceiling at `top`. */
  bool reaches(Cell cell, double top, const CeilingGap& gap) const;

private:
  const CellGrid& grid_;
  const ColumnTable& columns_;
  const PlanSlab& ceiling_;
  const PlanSlab& floor_;
};

} // namespace pcl::sedr
