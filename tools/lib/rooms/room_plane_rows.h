// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tool_cloud.h"

#include "sedr_segmentation/src/rooms/room_planes.h"

#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief Finds the main planes of the ceiling and the floor of every room of a file,
 * as the chain does, and labels the file anew: all of a ceiling keeps label 1 and its
 * room, of a floor what lies on the plane keeps label 2. The building says at which
 * heights planes are, and where a ceiling was hidden: there rows are added, copies of
 * another row of that ceiling but for their place.
 * @param grid_size cells in which areas are counted, metres
 * @param building as loadBuilding() reads it; without rooms: heights are
 * those that most of a ceiling and the lowest tenth of a floor have, no row is added
 * @return the planes, a ceiling and a floor a room */
std::vector<pcl::HorizontalPlane>
labelPlanesOfRooms(const RoomPlaneParameters& parameters,
                   double grid_size,
                   const Building& building,
                   ToolCloud& cloud);

} // namespace tools
} // namespace sedr
} // namespace pcl
