// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

namespace pcl::sedr {

/** @brief Moves rooms out of the reveals of their doorways.
 *
 * Where two rooms were parted at one side of the wall between them, the loop of one
 * goes on between the jambs, up to the other room. Below a lintel that part belongs to
 * the wall: the loop is closed along the face of the wall, so that the wall and what is
 * above its opening are no part of a room. A reveal is up to 0.6 m deep, its jambs
 * leave the wall by 60 degrees or more, and the lintel is at least 10 cm below the
 * ceiling. Without a lintel nothing changes. The parts of a face on both sides of a
 * doorway become one element if they are on one line, to 2 cm.
 *
 * O(doorways times elements). */
void closeReveals(Floorplan& plan);

} // namespace pcl::sedr
