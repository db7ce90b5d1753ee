// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "room_territory.h"
#include <pcl/sedr_filters/point_view.h>

#include <cstdint>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief The room of every point, -1 for none: that whose territory it lies in; where
 * two meet, that of most of the points within a cell and a half. A wall is one sheet
 * whose points belong together, be some of them, for the noise or for how the cells
 * lie, nearer to the ceiling on the other side. O(n log n). */
std::vector<std::int32_t> roomsOfPoints(const PointView& points,
                                        const RoomTerritory& territory,
                                        unsigned threads);

} // namespace sedr
} // namespace pcl
