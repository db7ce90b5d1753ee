// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../parting/room_parting.h"

#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_segmentation/impl/find_building.h>

#include <cstdint>
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

/** @brief Which parts of the air are what a floor mirrors of the room above it: below
 * most of their columns, as high as the air above, and no slab between: at half their
 * height, by the points at their ends, is the floor. O(n) for n points.
 * @param floors main floor of each part, metres
 * @return 1 for each such part */
std::vector<std::uint8_t> mirrorImages(const AirGaps& air,
                                       const PartedAir& parted,
                                       const PointView& points,
                                       const std::vector<double>& floors);

/** @brief Which parts of the air were seen only through panes of glass or in mirrors:
 * those whose points in their columns are nine tenths of that kind. O(n) for n points.
 * @param behind 1 for each point that was seen only through panes; empty: not known
 * @return 1 for each such part */
std::vector<std::uint8_t> viewsThroughPanes(const AirGaps& air,
                                            const PartedAir& parted,
                                            const PointView& points,
                                            const std::vector<std::uint8_t>& behind);

} // namespace pcl::sedr
