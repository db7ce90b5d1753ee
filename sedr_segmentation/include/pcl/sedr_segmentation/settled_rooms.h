// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/point_view.h>

#include <string>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Makes one plan of rooms that were fitted each for itself: parts them, see
 * separateRooms(), notes what was seen of their walls, see measureEvidence(), and
 * leaves out what was only looked into, see dropRoomsBeyondOpenings(). The others are
 * parted as if that had not been there: it takes nothing from them.
 *
 * @param plan its rooms have ids of their own; where two share one, what was taken from
 * others stays taken
 * @param points thinned to a point in 5 cm or denser
 * @param indices those of them that count
 * @param threads rooms measured at a time; 0: as many as there are processors
 * @return a sentence for every larger cut and for each room that was left out
 *
 * The cost of these three, and once more whenever rooms are left out. */
std::vector<std::string> settleRooms(Floorplan& plan,
                                     const PointView& points,
                                     const std::vector<int>& indices,
                                     unsigned threads = 0);

} // namespace sedr
} // namespace pcl
