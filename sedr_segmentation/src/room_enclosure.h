// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "room_pieces.h"

#include <vector>

namespace pcl {
namespace sedr {

/** @brief A room with what was not seen within it: gaps between its ceilings closed. */
CellMask solidOf(const Storey& storey, const CellMask& scope);

/** @brief How much of a room's outline is closed rather than open: the share with a
 * wall within 0.6 m, for a cupboard may hide the ceiling that far, less the share
 * across which the floor goes on and no wall stands. A wall goes up to the ceiling
 * beside it: below a soffit or a gallery to that. What is seen through a door or a
 * window only has no walls towards it, and less of its ceiling is seen than of its
 * floor.
 * @param members the pieces of the room's ceilings
 * @param floor the level of its floor */
double enclosureOf(const Storey& storey,
                   const CellMask& solid,
                   const std::vector<const Piece*>& members,
                   std::size_t floor);

/** @brief Whether something goes on below the floor along most of the outline: then it
 * is a table or a shelf. */
bool hasWallsBelow(const Storey& storey, const CellMask& solid, const Piece& main);

/** @brief Whether the ceiling of a piece ends nearly all around at what hangs or stands
 * there: beams, lintels and walls, as that of a passage does which is open to rooms on
 * all sides below them. That of a balcony ends in the open. */
bool isFramed(const Storey& storey, const CellMask& solid, const Piece& main);

} // namespace sedr
} // namespace pcl
