// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../levels/horizontal_levels.h"

#include "../profiles/column_table.h"
#include "sedr_filters/src/grids/cell_mask.h"
#include <pcl/sedr_filters/priors.h>

#include <vector>

namespace pcl {
namespace sedr {

/** @brief Whether a region is larger than furniture: than two beds side by side. */
bool
isLargerThanFurniture(const CellMask& region, double cell_size, const Priors& priors);

/** @brief A level that may be a platform, and the floor below it. */
struct PlatformStep {
  const Level& level;
  const Level& floor;
  CellGrid grid;
  ColumnTable columns;
  CellMask higher; ///< platforms above this one
  const std::vector<Level>& levels;
  const Priors& priors;

  double topAt(Cell cell) const { return level.slab.heightAt(grid.centre(cell)); }
  double floorAt(Cell cell) const { return floor.slab.heightAt(grid.centre(cell)); }

  /** @brief Whether a wall rises from the platform here. */
  bool isWall(Cell cell) const;

  /** @brief Whether something stands on the platform here, which hides how it goes on
   * behind. */
  bool isFurnished(Cell cell) const;

  /** @brief Whether something closes the platform here, down to the floor or to a tread
   * before it. */
  bool isRiser(Cell cell) const;

  /** @brief Height of the highest level below the platform within three cells. */
  double treadAt(Cell cell) const;
};

/** @brief Whether the rim of a region is closed all around, by risers or what stands on
 * it, in part by walls or what rises from it: along a fifth of what nothing hides, for
 * furniture is closed, too. What is larger than any needs no wall. */
bool isClosed(const PlatformStep& step, const CellMask& region);

} // namespace sedr
} // namespace pcl
