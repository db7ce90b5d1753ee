// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../profiles/room_columns.h"

#include <pcl/sedr_filters/priors.h>

#include "sedr_filters/src/grids/cell_mask.h"

namespace pcl::sedr {

/** @brief Classifies the profiles of a grid as walls of a room, partitions and columns.
 */
class OutlineWalls {
public:
  /** @param priors must outlive this */
  OutlineWalls(const RoomColumns& columns, const CeilingGap& gap, const Priors& priors)
      : columns_(columns)
      , gap_(gap)
      , priors_(priors)
  {}

  const Priors& priors() const { return priors_; }

  const CellGrid& grid() const { return columns_.grid(); }

  /** @brief Returns whether the upper half of the profile is occupied. */
  bool isVertical(Cell cell) const;

  /** @brief Returns whether a wall reaches the ceiling in the profile or its
   * neighbours; a cupboard does not. */
  bool isWall(Cell cell) const;

  /** @brief Returns whether a wall reaches the ceiling seen on both sides of a slit; a
   * cupboard does not. */
  bool isPartition(Cell cell) const;

  /** @brief Returns whether a hole is large enough and closed by a wall from floor to
   * ceiling along two fifths of its rim. Often only half of a column is visible. */
  bool isColumn(const CellMask& hole) const;

  /** @brief Returns whether a number of cells is at least the minimum area of a column.
   */
  bool isLargeEnough(std::size_t cells) const;

  /** @brief Returns the share of the common edge of `part` and `other` with a wall. */
  double wallShare(const CellMask& part, const CellMask& other) const;

private:
  /** @brief Returns whether the upper half of the profile or its neighbours is occupied
   * up to a ceiling at `top`. */
  bool isWallUpTo(Cell cell, double top) const;

  /** @brief Returns whether points reach the ceiling and occupy half of the room's
   * height in the profile or its neighbours. The upper half must be a surface, unlike a
   * lamp above a cupboard. */
  bool isFloorToCeiling(Cell cell) const;

  /** @brief Returns whether any single profile among the cell and its neighbours is
   * half occupied, in bins one cell high. A surface fills one profile; outliers scatter
   * over all of them. */
  bool isSurface(Cell cell, double low, double high) const;

  /** @brief Returns the height of the ceiling seen around a slit or a hole. */
  double topAroundGap(Cell cell) const;

  RoomColumns columns_;
  CeilingGap gap_;
  const Priors& priors_;
};

} // namespace pcl::sedr
