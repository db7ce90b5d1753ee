// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../air/air_gaps.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief What is believed of what parts rooms; lengths in metres. */
struct PartingParameters {
  double lintel = 0.12;       ///< a ceiling that dips by more may part what is beside
  double lintel_reach = 0.45; ///< half of the longest way below a lintel
  int smallest_lintel = 5;    ///< columns; fewer are points in the air below a ceiling
  double same_basin = 0.75;   ///< a neck this much as wide as the narrower side is none
  double thickest_wall = 0.6; ///< between two rooms
  double widest_door = 1.6;
  double least_lintel = 0.15; ///< mean dip of what is a door's
  double widest_passage = 4;  ///< of one below a deep lintel
  double deep_lintel = 0.2;
  double jamb = 0.25;         ///< a room goes on beside a door by so much
  double end_reach = 0.25;    ///< from the end of an opening to the wall there
  double same_floor = 1.0;    ///< floors of one room differ by less at an opening
  double deepest_shelf = 1.2; ///< what is higher and as deep is no floor
  double most_stacked = 0.1;  ///< share of the larger of two rooms that may lie above
                              ///< the other if they are one: stairs
  double widest_share = 0.8;  ///< of the width of the wider room that is open, but for
                              ///< doors with a lintel
  double least_open = 0.5;    ///< share of the wall between that joins two rooms
  double most_open = 0.5;     ///< share of a room's outline that doors may be
  double smallest_room = 1.0; ///< square metres
};

/** @brief An opening between two rooms. */
struct RoomOpening {
  std::uint32_t a = 0; ///< rooms, by index; a < b
  std::uint32_t b = 0;
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();     ///< in plan
  Eigen::Vector2d direction = Eigen::Vector2d::UnitX(); ///< along the wall
  double width = 0;
  double bottom = 0; ///< z of the floor in it
  double top = 0;    ///< z of its lintel
  double dip = 0;    ///< mean, of the ceiling below that beside it
};

/** @brief The air parted into what may be rooms. */
struct PartedAir {
  static constexpr std::int32_t no_room = -1;
  std::vector<std::int32_t> room; ///< of each gap, no_room for specks
  std::size_t rooms = 0;
  std::vector<RoomOpening> openings;   ///< between different rooms
  std::vector<std::uint8_t> is_reveal; ///< of each gap, see revealsOf()
};

/** @brief Parts air into rooms: basins of the distance from what ends the air, lintels
 * counted as ends, grown over what is left; then neighbours are joined again unless a
 * wall is between them. Two are parted by what is between them as a whole: if walls
 * make up most of it, or if the opening is a door or a passage: no wider than one, with
 * a lintel and with a wall beside it on one side, or with jambs on both, and with walls
 * at both of its ends. A room is one height field: what lies above each other is never
 * joined, nor are floors a step of a storey apart. O(gaps log gaps). Rooms are numbered
 * by size, largest first. */
PartedAir partRooms(const AirGaps& air, const PartingParameters& parameters);

} // namespace sedr
} // namespace pcl
