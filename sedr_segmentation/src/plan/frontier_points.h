// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "room_territory.h"
#include <pcl/sedr_filters/point_view.h>

#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief Returns the room of every point, -1 for none: the room whose territory
 * contains it. Where two territories meet, the majority of the points within 1.5 cells
 * decides, so that all points of a wall face get one room. Noise and grid position may
 * put some of them nearer to the other room's ceiling. O(n log n). */
std::vector<std::int32_t> roomsOfPoints(const PointView& points,
                                        const RoomTerritory& territory,
                                        unsigned threads);

} // namespace pcl::sedr
