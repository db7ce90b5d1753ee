// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "room_parting.h"

#include <pcl/sedr_segmentation/building.h>

#include <cstdint>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Which parts of the air were only looked into, through a door or a window of
 * another one, or stand apart from all: seen, but not scanned from within.
 *
 * Where a scanner stood in a room, it saw the wall with the opening from within, and
 * the room's air reaches that wall beside the opening. What was seen through the
 * opening is a fan that starts at it. Parts with walls around most of their outline are
 * rooms, wherever the scanner stood; the largest part is one, too.
 * @param parts by size, largest first, ids from 1
 * O(columns) for every opening. */
std::vector<std::uint8_t> lookedInto(const std::vector<BuildingRoom>& parts,
                                     const std::vector<RoomOpening>& openings,
                                     double cell_size);

} // namespace sedr
} // namespace pcl
