// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/priors.h>

#include <vector>

namespace pcl::sedr {

/** @brief Leads the boundary of a room straight past recesses of its ceiling's outline
 * that are none of its plan. Those of up to 0.6 m between two stretches of one straight
 * wall are looked at.
 *
 * One is none of the plan if the wall goes on below it, as below a window or a niche
 * that reaches the ceiling. Or the wall goes on above it, as above a shut door, up to
 * the ceiling before it. Or nothing was seen of its back. Or the back is a pane: both
 * sides go on behind it. Narrow ones are closed below a lintel only. The wall that
 * closes one is on the line of both stretches, where its corners are moved to.
 * @param room whose floor, ceiling and boundary are known
 * @param indices points of the room and near it
 * @return niches for those above a wall of whose back half was seen, as of an alcove
 * above a low wall with a window in it: fitNiches() does not find one through which one
 * sees on. O(n) for each recess that is looked at. */
std::vector<PlanNiche> closeRecesses(PlanRoom& room,
                                     const PointView& points,
                                     const std::vector<int>& indices,
                                     const Priors& priors = {});

/** @brief Closes recesses of a room's boundary, and drops its bumps of up to
 * `minimum_length` metres, see dropBumps(). Recesses first, as a pier between two
 * windows is like a bump of their panes, and again after the bumps, as one with a nick
 * in its back or its jambs is then known as such.
 * @return the niches of closeRecesses() */
std::vector<PlanNiche> straightenWalls(PlanRoom& room,
                                       const PointView& points,
                                       const std::vector<int>& indices,
                                       double minimum_length,
                                       const Priors& priors = {});

} // namespace pcl::sedr
