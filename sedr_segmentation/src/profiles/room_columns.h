// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ceiling_gap.h"
#include "column_table.h"
#include <pcl/sedr_filters/floorplan.h>

namespace pcl {
namespace sedr {

/** @brief What the columns of a grid tell between the floor and the ceiling of a room.
 * What it is made of must outlive it. */
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

  /** @brief Halfway between the floor and a height above it. */
  double middleBelow(Cell cell, double top) const { return (floorAt(cell) + top) / 2; }

  /** @brief Height of whatever ceiling was seen within `reach` cells, a soffit's
   * perhaps; the floor's where nothing was. */
  double topAround(Cell cell, int reach) const;

  /** @brief Share of the six parts of the upper half below `top`, but for the `below`
   * metres next to it, in which the column or those within `radius` cells hold a
   * point. */
  double upperShare(Cell cell, double top, double below, int radius) const;

  /** @brief Whether something in the column or beside it goes up to a ceiling at `top`.
   */
  bool reaches(Cell cell, double top, const CeilingGap& gap) const;

private:
  const CellGrid& grid_;
  const ColumnTable& columns_;
  const PlanSlab& ceiling_;
  const PlanSlab& floor_;
};

} // namespace sedr
} // namespace pcl
