// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../air/air_gaps.h"
#include "parting_parameters.h"
#include "room_labels.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief An opening between two rooms. */
struct RoomOpening {
  std::uint32_t a = 0; ///< rooms, by index; a < b
  std::uint32_t b = 0;
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();     ///< in plan
  Eigen::Vector2d direction = Eigen::Vector2d::UnitX(); ///< along the wall
  double width = 0;
  double bottom = 0; ///< z of the floor in it
  double top = 0;    ///< z of its lintel
};

/** @brief The openings between rooms: where links hang together by which one gets from
 * one room to another, but for those over the edge of a gallery, and with those where
 * one climbs through a slab, see AirGaps::isDrop() and AirGaps::climb(). O(gaps). */
std::vector<RoomOpening> openingsBetween(const AirGaps& air, RoomLabels& rooms);

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

/** @brief Parts air at its constrictions: basins of the distance from what ends the
 * air, lintels counted as ends. Two basins that meet in a neck about as wide as the
 * narrower of them are one. What no basin holds, below lintels, goes to the nearest.
 * O(gaps log gaps).
 * @param dip of each gap, see dipOfCeiling()
 * @return a label for each gap, PartedAir::no_room for what none reaches */
std::vector<std::int32_t> roomBasins(const AirGaps& air,
                                     const std::vector<float>& dip,
                                     const PartingParameters& parameters);

} // namespace pcl::sedr
