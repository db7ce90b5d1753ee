// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../levels/horizontal_levels.h"

#include "../profiles/column_table.h"
#include "sedr_filters/src/grids/cell_mask.h"
#include <pcl/sedr_filters/priors.h>

#include <vector>

namespace pcl::sedr {

/** @brief Returns whether a region is larger than furniture, i.e. two adjacent beds. */
bool
isLargerThanFurniture(const CellMask& region, double cell_size, const Priors& priors);

/** @brief A candidate platform and the floor below it. */
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

  /** @brief Returns whether a wall rises from the platform in a cell. */
  bool isWall(Cell cell) const;

  /** @brief Returns whether an object on the platform hides its rim in a cell. */
  bool isFurnished(Cell cell) const;

  /** @brief Returns whether a riser closes the platform down to the floor or a tread.
   */
  bool isRiser(Cell cell) const;

  /** @brief Returns the height of the highest level below within three cells. */
  double treadAt(Cell cell) const;
};

/** @brief Returns whether the rim of a region is closed by risers, objects on it, walls
 * and higher platforms. A fifth of the visible rim must be walls or higher platforms,
 * as furniture has closed sides, too. Larger regions need no wall. */
bool isClosed(const PlatformStep& step, const CellMask& region);

} // namespace pcl::sedr
