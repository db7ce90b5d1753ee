// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../faces/room_cells.h"
#include "../faces/wall_lines.h"

#include <cstddef>
#include <vector>

namespace pcl::sedr {

/** @brief Weights of the energy of a room's region, in units of a metre of border that
 * nothing explains.
 *
 *     E(region) = sum over its border    length x (0 at a surface up to the ceiling
 * that the room sees, `glass` at a pane and on the line of a lintel, `line` at a
 * surface that others see and on the line of a wall, else 1)
 *               + sum over cells left out    `seen` a square metre of seen ceiling
 *               + sum over cells taken in    `unseen` a square metre that nobody saw,
 *                     `wall` within a wall, `reveal` in a reveal
 *
 * Fixed are seen cells two cells inside, of this room and of others. A region hangs
 * together: a part joins where that costs less than the part is worth. */
struct RegionEnergy {
  double line = 0.1;
  double glass = 0.5;
  double seen = 4;
  double reveal = 0.3;
  double unseen = 0.6;
  double wall = 3;
  double max_wall = 0.6;    ///< Priors::max_wall; a recess behind a line that is no
                            ///< deeper is a reveal, if its back is open or the wall
                            ///< goes on above or below it;
  double max_doorway = 0.9; ///< likewise, before another room
};

/** @brief The region of a room in plan. */
struct RoomRegion {
  CellMask cells;
  CellMask beyond;   ///< reveals that it leaves out, up to what closes them
  double lost = 0;   ///< seen ceiling left out more than two cells wide, without
                     ///< reveals, square metres
  double unseen = 0; ///< taken in, though nobody saw it, square metres
};

/** @brief Adds the cells of a mask that lie in the box of another. */
void addCells(const CellMask& mask, CellMask& sum);

/** @brief Rooms side by side. */
struct Storey {
  std::vector<std::size_t> rooms; ///< that belong to it
  std::vector<WallLine> lines;    ///< of their walls, and of rooms beside them
  std::vector<WallLine>
      lintels; ///< and parapets: all there may be of a wall of windows
};

/** @brief Groups rooms by the heights that they share, and finds the lines of each
 * group's walls. */
std::vector<Storey> storeysOf(const std::vector<RoomCells>& rooms,
                              const CellGrid& grid,
                              const WallLineParameters& parameters,
                              unsigned threads);

/** @brief Finds the region of every room by one minimum cut, and one more each time a
 * part that lies apart is joined. Regions do not overlap where rooms share heights.
 * O(cells near walls, x log) a cut. */
std::vector<RoomRegion> roomRegions(const std::vector<RoomCells>& rooms,
                                    const std::vector<Storey>& storeys,
                                    const CellGrid& grid,
                                    const RegionEnergy& energy,
                                    unsigned threads);

} // namespace pcl::sedr
