// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../overhead/ceiling_faces.h"

#include <pcl/sedr_surface/floorplan_ifc.h>

#include <string>

namespace pcl::sedr {

/** @brief Returns the row of a room.
 * @param ceiling of the room
 * @param storey its name
 * @param volume of its solid */
RoomRow roomRow(const Floorplan& plan,
                const CeilingFaces& ceiling,
                const std::string& storey,
                double volume);

} // namespace pcl::sedr
