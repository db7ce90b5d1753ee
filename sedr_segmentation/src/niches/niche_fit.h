// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/priors.h>

#include <vector>

namespace pcl {
namespace sedr {

/** @brief What a niche is; lengths in metres. */
struct NicheParameters {
  Priors priors;
  double cell_size = 0.05;
  unsigned threads = 1; ///< that share the walls; 0: as many as there are processors
};

/** @brief How far beyond a back is looked for what is seen there, metres. */
inline double
viewBehind(const Priors& priors)
{
  return 2 * priors.run_gap;
}

/** @brief How far from a room's ceiling the points that fitNiches() looks at may be,
 * metres: walls stand up to two cells beyond it. */
inline double
nicheReach(const NicheParameters& parameters = {})
{
  return parameters.priors.max_niche_depth + viewBehind(parameters.priors) +
         2 * parameters.cell_size;
}

/** @brief Finds the niches in the straight walls of a room: where nothing is on the
 * wall but a closed back is behind it.
 *
 * Each wall is unrolled into cells along it and up it. A region of cells without wall
 * points, behind which most points lie at one depth and hardly any farther away, is a
 * niche: through a window and an open door one sees on, and where furniture hides the
 * wall nothing is seen behind it. A shallow recess that starts at the floor is a closed
 * door. The head of one that reaches the ceiling is the ceiling; what also starts at
 * the floor is a part of the room. Where another wing of the room lies behind the wall,
 * there is none. Of niches one above the other the one with the largest mouth counts,
 * for a plan has one floor and one ceiling at a place. The sides, the bottom and the
 * top go through the points seen on them. O(n) a wall.
 * @param room with boundary, floor and ceiling
 * @param around indices of all points of the room and up to nicheReach() from it */
std::vector<PlanNiche> fitNiches(const PointView& points,
                                 const std::vector<int>& around,
                                 const PlanRoom& room,
                                 const NicheParameters& parameters = {});

} // namespace sedr
} // namespace pcl
