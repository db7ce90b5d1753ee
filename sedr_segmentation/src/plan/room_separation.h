// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/priors.h>

#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief Resolves overlaps between the rooms of a plan.
 *
 * Where a wall was hidden, a room may extend beyond its neighbour's wall. The overlap
 * of two rooms of one storey is assigned to the room with more wall length seen there,
 * else to the smaller one. The other room is cut back to 1 cm from it, with its columns
 * and details. Niches that reach into another room are removed. Finally, slits and
 * spikes are cut off, see cutNecks(), and details are clipped to their rooms.
 *
 * @param points thinned to 5 cm or denser, to measure which walls were seen
 * @param indices the points to use
 * @return a sentence for every cut of more than 0.1 m2
 *
 * Cost: O(r^2) for the boxes of r rooms, O(n m) for the walls of rooms whose boxes
 * overlap, and a measurement of the evidence of two rooms per overlap. Deterministic.
 */
std::vector<std::string> separateRooms(Floorplan& plan,
                                       const PointView& points,
                                       const std::vector<int>& indices,
                                       const Priors& priors = {});

} // namespace pcl::sedr
