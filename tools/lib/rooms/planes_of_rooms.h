// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "labelled_rooms.h"

#include <vector>

namespace pcl::sedr::tools {

/** @brief Finds the main planes of ceiling and floor of every room of a file, as the
 * chain does, and labels the file again. All ceiling points keep label 1 and their
 * room; floor points keep label 2 if they are on the plane. The building gives the
 * heights of planes and the hidden ceilings. There, rows are added: copies of another
 * row of that ceiling with a new position.
 * @param grid_size cells for measuring areas, metres
 * @param building from loadBuilding(). Without rooms, no rows are added and heights are
 * those of most of a ceiling and of the lowest tenth of a floor
 * @return the planes, a ceiling and a floor per room */
std::vector<pcl::HorizontalPlane>
labelPlanesOfRooms(const RoomPlaneParameters& parameters,
                   double grid_size,
                   const Building& building,
                   ToolCloud& cloud);

} // namespace pcl::sedr::tools
