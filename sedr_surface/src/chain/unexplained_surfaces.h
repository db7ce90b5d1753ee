// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/plan_warning.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/priors.h>
#include <pcl/sedr_segmentation/building.h>

#include <vector>

namespace pcl::sedr {

/** @brief Returns what was seen and the plan does not explain, in connected places of
 * 0.25 m2 and more.
 *
 * Floors and ceilings: columns of air that end more than 10 cm off the model, and off
 * its noise; one warning a room for each if they make up 2 % of it, or as much as
 * furniture covers; and floor that was not seen if furniture cannot hide it. What may
 * be furniture by its size, see isAsFurniture(), does not count. Places within two
 * cells of a wall or column do not count, nor do those with points on the model, nor
 * those outside of the plan, which coverageOf() tells of.
 *
 * Walls and sides of columns: places with nothing on them and something seen behind,
 * not before, which is in no other room, and ceilings that go on behind, if they make
 * up 1 % of all surfaces of the room; and what lies 5 to 15 cm before them, if it makes
 * up 2 %. Openings and their reveals do not count. Things that reach up to the ceiling,
 * as walls do, and are none: one warning a room.
 *
 * O(points + columns of the building).
 * @param points thinned
 * @param building its rooms have the ids of those of the plan */
std::vector<PlanWarning> unexplainedSurfaces(const PointView& points,
                                             const Building& building,
                                             const Floorplan& plan,
                                             const Priors& priors = {});

} // namespace pcl::sedr
