// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../parting/room_parting.h"

#include <pcl/sedr_segmentation/building.h>

#include <vector>

namespace pcl::sedr {

/** @brief Each part of the air as a room, with its columns, heights, area and
 * enclosure, whether it is one or not; in their order, ids from 1. O(gaps). */
std::vector<BuildingRoom> describeRooms(const AirGaps& air, const PartedAir& parted);

/** @brief Why a part of the air is no room, for people; empty if it is one.
 * @param is_reached whether one walks into it from another, or it is the largest: into
 * what is closed a scanner may look through glass
 * @param is_entered whether one walks into it: then it is not outdoors
 * @param[out] kind what it is instead */
std::string noRoomBecause(const BuildingRoom& room,
                          double cell_size,
                          bool is_reached,
                          bool is_entered,
                          const BuildingParameters& parameters,
                          LeftOutKind& kind);

/** @brief Why a room that one walks into is none: most of its outline is where the view
 * ended, and not along its walls, as panes are. Empty if it is one.
 * @param box area of the smallest rectangle around it */
std::string seenInPart(const BuildingRoom& room, double box);

} // namespace pcl::sedr
