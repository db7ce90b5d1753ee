// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/point_view.h>

#include <string>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Takes out of a plan what was only looked into from another room, through a
 * door or a window: a stairwell, a neighbour's hall.
 *
 * Where a scanner stood in a room, each of its walls was seen, or something stands
 * before it. Through an opening all may be seen but the wall with that opening, from
 * within. So a room is left out if walls behind which another room lies within a metre,
 * a fifth of its perimeter and 1.5 m at least, were neither seen nor are hidden by
 * anything. A room that only such rooms are behind stays, and so does one with a glass
 * front and an open door.
 *
 * @param plan with the evidence of its walls, see measureEvidence()
 * @param points thinned to a point in 5 cm or denser
 * @param indices those of them that count
 * @return a sentence for each room that was left out
 *
 * O(r) for r rooms that were seen whole; O(n + r) for each other one. */
std::vector<std::string> dropRoomsBeyondOpenings(Floorplan& plan,
                                                 const PointView& points,
                                                 const std::vector<int>& indices);

} // namespace sedr
} // namespace pcl
