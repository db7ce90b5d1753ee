// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/priors.h>

namespace pcl::sedr {

/** @brief Moves rooms out of the reveals of their doorways.
 *
 * Where two rooms were parted at one side of the wall between them, the loop of one
 * goes on between the jambs, up to the other room. Below a lintel that part belongs to
 * the wall: the loop is closed along the face of the wall, so that the wall and what is
 * above its opening are no part of a room, and the details of the room are cut there
 * too. A reveal is at most Priors::max_wall deep, its jambs leave the wall by 60
 * degrees or more, and the lintel is at least Priors::min_drop below the ceiling.
 * Without a lintel nothing changes. The parts of a face on both sides of a doorway
 * become one element if they are on one line within twice Priors::wall_noise.
 *
 * A loop of n elements costs O(n) for each doorway of its room, and trimDetails() once
 * if a reveal was closed. */
void closeReveals(Floorplan& plan, const Priors& priors = {});

} // namespace pcl::sedr
