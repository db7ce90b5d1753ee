// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/priors.h>

#include <string>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Parts the rooms of a plan that run into each other, so that none do.
 *
 * Where a wall was hidden, a room may be closed beyond that of its neighbour. What two
 * rooms of one storey have in common is left to the one whose walls were seen there;
 * where none were, to the smaller one. The other is cut back to a centimetre from it,
 * and its columns and details with it. Niches that reach into another room are dropped.
 * Last, slits and spikes of any outline are cut off, see cutNecks(), and what of the
 * details reaches out of their room.
 *
 * @param points thinned to a point in 5 cm or denser: they tell which walls were seen
 * @param indices those of them that count
 * @return a sentence for every cut of more than a tenth of a square metre
 *
 * The boxes of any two rooms are compared, O(r^2), the walls of those whose boxes meet,
 * O(n m); for every overlap, the evidence of two rooms is measured. Deterministic. */
std::vector<std::string> separateRooms(Floorplan& plan,
                                       const PointView& points,
                                       const std::vector<int>& indices,
                                       const Priors& priors = {});

} // namespace sedr
} // namespace pcl
