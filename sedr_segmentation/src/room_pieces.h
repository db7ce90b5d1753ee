// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_segmentation/column_table.h>
#include <pcl/sedr_segmentation/room_segmentation.h>

#include <cstddef>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief A connected piece of one ceiling. */
struct Piece {
  std::size_t level = 0;
  std::size_t floor = 0;
  CellMask cells; ///< in a box of its own
  std::size_t size = 0;
};

/** @brief What all steps look at. */
struct Storey {
  const std::vector<Level>& levels;
  const RoomParameters& parameters;
  CellGrid grid;
  CellBox box;
  ColumnTable columns;

  double heightOf(std::size_t level, Cell cell) const
  {
    return levels[level].slab.heightAt(grid.centre(cell));
  }

  /** @brief Whether a wall goes up to `top` in this column. */
  bool isWallBelow(Cell cell, double top) const
  {
    return columns.share(cell, top - 0.6, top - 0.1, 5, 0) >= 0.6;
  }

  /** @brief Whether something closes the column for a decimetre below `top`, be it only
   * the low lintel of a door. */
  bool isClosedBelow(Cell cell, double top) const
  {
    return columns.share(cell, top - 0.2, top - 0.08, 2, 0) >= 1;
  }

  /** @brief Whether the column is a wall from the floor up to the ceiling: a cupboard
   * is not, nor is what stands below a beam. */
  bool isWall(Cell cell, double floor, double top) const
  {
    return columns.share(cell, top - 0.36, top - 0.08, 3, 1) >= 1 &&
           columns.share(cell, floor + 0.2, top - 0.15, 8, 0) >= 0.5 &&
           columns.share(cell, (floor + top) / 2, top - 0.15, 5, 0) >= 0.5;
  }

  /** @brief Whether a sill stands in the column: something upright from near the floor
   * up to 0.8 m. */
  bool isSill(Cell cell, double floor) const
  {
    return columns.share(cell, floor + 0.2, floor + 0.8, 4, 1) >= 0.75;
  }
};

/** @brief The pieces of one ceiling level.
 * @param[in,out] passages cells between pieces, in openings as high as the rooms */
std::vector<Piece>
piecesOf(const Storey& storey, std::size_t level, CellMask& passages);

/** @brief The lowest floor with enough of the piece; false where there is none. */
bool findFloor(const Storey& storey, Piece& piece);

} // namespace sedr
} // namespace pcl
