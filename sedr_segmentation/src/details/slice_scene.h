// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../profiles/column_table.h"
#include "sedr_filters/src/base/exactness.h"
#include "sedr_filters/src/base/parallel.h"
#include "slice_detail.h"

namespace pcl {
namespace sedr {

/** @brief One room on the grid. */
struct SliceScene {
  const SliceParameters& parameters;
  const PlanSlab& slab;
  double floor_height;
  CellGrid grid;
  CellMask ceiling;
  ColumnTable columns;

  /** @brief Calls `see(i)` for the number of every cell of the box, in any order and
   * from several threads at once. */
  template <typename See>
  void forEachCell(const See& see) const
  {
    parallelBlocks(ceiling.values().size(), cells_a_block, parameters.threads,
                   [&](std::size_t begin, std::size_t end) {
                     for (std::size_t i = begin; i < end; ++i)
                       see(i);
                   });
  }

  double ceilingAt(Cell cell) const { return slab.heightAt(grid.centre(cell)); }

  /** @brief Height of the slice at `fraction` of the room's height below the ceiling.
   */
  double sliceAt(Cell cell, double fraction) const
  {
    const double top = ceilingAt(cell);
    return top - fraction * (top - floor_height);
  }
};

/** @brief The uppermost run of a column if it starts above half the room's height and
 * is not the ceiling: an underside, or a riser between two heights. */
bool hasOwnTop(const SliceScene& scene, Cell cell, ColumnRun& top);

/** @brief The cells of all details: regions of one height that join the ceiling,
 * directly or through each other, their risers, and what else the slices enclosed with
 * them.
 * @param[out] refused cells of the regions of one height that are no details */
CellMask detailCells(const SliceScene& scene,
                     const CellMask& enclosed_by_slices,
                     CellMask& refused);

} // namespace sedr
} // namespace pcl
