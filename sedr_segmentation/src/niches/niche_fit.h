// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/priors.h>

#include <vector>

namespace pcl::sedr {

/** @brief Parameters of the niche detection; lengths in metres. */
struct NicheParameters {
  Priors priors;
  double cell_size = 0.05;
  unsigned threads = 1; ///< 0: all processors
};

/** @brief Returns the depth searched for points behind the back of a niche, metres. */
inline double
viewBehind(const Priors& priors)
{
  return 2 * priors.run_gap;
}

/** @brief Returns the maximum distance in plan from a room's ceiling of the points used
 * by fitNiches(), metres. Walls stand up to two cells beyond the ceiling. */
inline double
nicheReach(const NicheParameters& parameters = {})
{
  return parameters.priors.max_niche_depth + viewBehind(parameters.priors) +
         2 * parameters.cell_size;
}

/** @brief Finds the niches in the straight walls of a room: openings in the wall with a
 * closed back behind.
 *
 * Each wall is unrolled into a grid along and up. A niche is a region of cells without
 * wall points, with most points behind it at one depth and hardly any farther away.
 * Windows and open doors show points farther away; furniture before the wall shows
 * none. A shallow recess is a closed door or a window with its blind down; one from
 * floor to ceiling is part of the room. The top of a recess that reaches the ceiling is
 * the ceiling. There is no niche where another wing of the room lies behind the wall.
 * Of niches above each other, only the one with the largest mouth is kept, as a plan
 * has one floor and one ceiling per position. Sides, bottom and top fit their points.
 * O(n) per wall.
 * @param room with boundary, floor and ceiling
 * @param around indices of all points of the room and up to nicheReach() from it */
std::vector<PlanNiche> fitNiches(const PointView& points,
                                 const std::vector<int>& around,
                                 const PlanRoom& room,
                                 const NicheParameters& parameters = {});

/** @brief Removes the niches that overlap another room of the same heights, or a niche
 * of one. */
void dropSharedNiches(Floorplan& plan);

} // namespace pcl::sedr
