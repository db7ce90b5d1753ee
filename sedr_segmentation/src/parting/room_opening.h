// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../air/air_gaps.h"
#include "room_labels.h"

#include <Eigen/Core>

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

} // namespace pcl::sedr
