// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../air/air_gaps.h"
#include "parting_parameters.h"
#include "room_opening.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief A border where two parts of the air were taken for one room or for two, which
 * may be wrong. */
struct PartingDoubt {
  std::uint32_t a = 0; ///< rooms, by index; the same where they were joined
  std::uint32_t b = 0;
  Eigen::Vector2d at = Eigen::Vector2d::Zero(); ///< middle of the border
  double area = 0;   ///< of the smaller of both, square metres
  double chance = 0; ///< that it is wrong
};

/** @brief The air parted into what may be rooms. */
struct PartedAir {
  static constexpr std::int32_t no_room = RoomLabels::no_room;
  std::vector<std::int32_t> room; ///< of each gap, no_room for specks
  std::size_t rooms = 0;
  std::vector<RoomOpening> openings; ///< between different rooms
  std::vector<PartingDoubt> doubts;
};

/** @brief Parts air into rooms: basins of the distance from what ends the air (see
 * roomBasins()), of which neighbours are joined again while they are more likely one
 * room than two (see BorderOdds), the most likely first, each time judged by all that
 * is then between them. Rooms are numbered by size, largest first; each is one height
 * field, of which the tallest gap of a column stays. O(gaps log gaps). */
PartedAir partIntoRooms(const AirGaps& air, const PartingParameters& parameters);

} // namespace pcl::sedr
