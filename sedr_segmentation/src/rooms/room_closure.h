// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../parting/parting_parameters.h"
#include "../parting/room_parting.h"

#include <pcl/sedr_segmentation/building.h>

#include <cstdint>
#include <functional>
#include <vector>

namespace pcl::sedr {

/** @brief What may become of a part of the air when rooms are completed. */
enum class PartUse {
  Room,  ///< it is a room, which is completed
  Spare, ///< rooms may take it
  Other  ///< it stays as it is
};

/** @brief Asks whether a part is a room, completed as it would be.
 * @param box area of the rectangle around what was seen of it, along its walls */
using RoomTest =
    std::function<bool(std::uint32_t part, const BuildingRoom& completed, double box)>;

/** @brief Completes rooms where they end at what nobody saw: behind machines, piers and
 * columns. Of all outlines around what was seen of a room the one is taken of which the
 * least length was not seen; along the lines on which walls of the room were seen that
 * counts less, so that walls go on until they meet. The columns that are added tell
 * what of them was seen. Larger rooms come first, and what is none once it is completed
 * stays as it was. Memory O(n) for the n cells of the box around a room, in its main
 * directions; time that of a minimum cut of a grid of as many.
 * @param use of each part
 * @param[in,out] parts parts of the air, see describeRooms() */
void closeRooms(const AirGaps& air,
                const PartedAir& parted,
                const std::vector<PartUse>& use,
                const PartingParameters& parameters,
                std::vector<BuildingRoom>& parts,
                const RoomTest& isRoom);

} // namespace pcl::sedr
