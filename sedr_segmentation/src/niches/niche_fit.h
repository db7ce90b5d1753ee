// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/point_view.h>

#include <vector>

namespace pcl {
namespace sedr {

/** @brief What a niche is; lengths in metres. */
struct NicheParameters {
  double cell_size = 0.05;
  double least_depth = 0.09; ///< of those built 0.1 deep, as they are measured
  double greatest_depth = 1.0;
  double view = 0.3;         ///< how far beyond a back is looked for what is seen there
  double least_size = 0.3;   ///< width and height
  double least_alcove = 0.2; ///< depth of one that starts at the floor
  double minimum_coverage = 0.7; ///< share of its back that was seen
  double greatest_view = 0.1;    ///< share of its back, or rim, beyond which one sees
  unsigned threads = 1; ///< that share the walls; 0: as many as there are processors
};

/** @brief How far from a room's ceiling the points that fitNiches() looks at may be,
 * metres: walls stand up to two cells beyond it. */
inline double
nicheReach(const NicheParameters& parameters = {})
{
  return parameters.greatest_depth + parameters.view + 2 * parameters.cell_size;
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
