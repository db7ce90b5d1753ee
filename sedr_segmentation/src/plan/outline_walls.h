// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../profiles/room_columns.h"

#include <pcl/sedr_filters/priors.h>

#include "sedr_filters/src/grids/cell_mask.h"

namespace pcl {
namespace sedr {

/** @brief Which columns of a grid hold walls of a room, partitions and columns. */
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

  /** @brief Whether the upper half of the column is occupied. */
  bool isUpright(Cell cell) const;

  /** @brief Whether a wall goes up to the ceiling in the column or beside it: a
   * cupboard does not. */
  bool isWall(Cell cell) const;

  /** @brief The same where the ceiling is seen on both sides of a slit: no cupboard
   * reaches it. */
  bool isPartition(Cell cell) const;

  /** @brief Whether a hole is large enough and closed by a wall from the floor up to
   * the ceiling, along two fifths of its rim: from where people stand, half of a column
   * is in view. */
  bool isColumn(const CellMask& hole) const;

  /** @brief Whether a hole of so many cells is as large as the smallest column. */
  bool isLargeEnough(std::size_t cells) const;

  /** @brief Share of the common edge of `part` and `other` along which a wall stands.
   */
  double wallShare(const CellMask& part, const CellMask& other) const;

private:
  /** @brief Whether the upper half of the column, or of those beside it, is occupied up
   * to a ceiling at `top`. */
  bool isWallUpTo(Cell cell, double top) const;

  /** @brief Whether something stands in the column or beside it, up to just below the
   * ceiling, over half of the room's height and of its upper half too: a lamp above a
   * cupboard leaves that open. */
  bool isFloorToCeiling(Cell cell) const;

  /** @brief Whether points fill half of the parts, a cell high, of the column or of one
   * beside it: a surface does in one column, points scattered in the air only here and
   * there in all of them. */
  bool isSurface(Cell cell, double low, double high) const;

  /** @brief Height of the ceiling seen around a slit or a hole. */
  double topAroundGap(Cell cell) const;

  RoomColumns columns_;
  CeilingGap gap_;
  const Priors& priors_;
};

} // namespace sedr
} // namespace pcl
