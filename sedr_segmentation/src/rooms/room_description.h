// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../parting/room_parting.h"

#include <pcl/sedr_segmentation/impl/find_building.h>

#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief Each part of the air as a room, with its columns, heights, area and
 * enclosure, whether it is one or not; in their order, ids from 1. O(gaps). */
std::vector<BuildingRoom> describeRooms(const AirGaps& air, const PartedAir& parted);

/** @brief What a part of the air is. */
struct Verdict {
  std::string reason; ///< why it is no room, for people; empty: it is one
  LeftOutKind kind = LeftOutKind::Low; ///< what it is instead

  bool isRoom() const { return reason.empty(); }
};

/** @brief Whether a part of the air has what a room has: height, floor and ceiling, and
 * walls.
 * @param is_entered false: a scanner may have looked into it through glass */
Verdict noRoomBecause(const BuildingRoom& room,
                      double cell_size,
                      bool is_entered,
                      const BuildingParameters& parameters,
                      const PartingParameters& of_parting);

} // namespace pcl::sedr
