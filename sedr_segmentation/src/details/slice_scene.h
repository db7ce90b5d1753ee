// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../profiles/column_table.h"
#include "sedr_filters/src/base/exactness.h"
#include "sedr_filters/src/base/parallel_for.h"
#include "slice_detail.h"

namespace pcl::sedr {

/** @brief A room on the grid. */
struct SliceScene {
  const SliceParameters& parameters;
  const PlanSlab& slab;
  double floor_height;
  CellGrid grid;
  CellMask ceiling;
  ColumnTable columns;

  /** @brief Calls `see(i)` for every cell number of the box, in any order and from
   * several threads concurrently. */
  template <typename See>
  void forEachCell(const See& see) const
  {
    parallelFor(ceiling.values().size(), cells_a_block, parameters.threads,
                [&](std::size_t i) { see(i); });
  }

  double ceilingAt(Cell cell) const { return slab.heightAt(grid.centre(cell)); }

  /** @brief Returns the height of a slice at `fraction` of the room height from the
   * top. */
  double sliceAt(Cell cell, double fraction) const
  {
    const double top = ceilingAt(cell);
    return top - fraction * (top - floor_height);
  }
};

/** @brief Finds the uppermost run of a profile if it starts above half the room's
 * height and is not the ceiling: an underside or a riser. */
bool hasOwnTop(const SliceScene& scene, Cell cell, ColumnRun& top);

/** @brief Returns the cells of all details: regions of one height connected to the
 * ceiling, directly or through each other, their risers, and other cells that the
 * slices enclose with them.
 * @param[out] refused cells of the regions of one height that are no detail */
CellMask detailCells(const SliceScene& scene,
                     const CellMask& enclosed_by_slices,
                     CellMask& refused);

} // namespace pcl::sedr
