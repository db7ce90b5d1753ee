// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "facet_choice.h"
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/priors.h>

#include <vector>

namespace pcl::sedr {

/** @brief A floor on which furniture may stand. */
struct FurnishedFloor {
  const PlanSlab& main; ///< plane of most of it
  const Priors& priors;
};

/** @brief Returns whether furniture may be as large as a level surface above a floor:
 * the lower the smaller; and higher than tables no deeper than cupboards.
 * @param depth twice the area by the length of the outline: of a long strip its width
 */
bool isAsFurniture(double area, double depth, double height, const Priors& priors);

/** @brief Takes from a choice the pieces that are of furniture. From the main plane
 * outwards, a piece is of the floor if the plane is not seen below it, and it is larger
 * than furniture, or reached by a step and not higher than what is along a part of its
 * rim.
 * @param around all points in and near the room */
void dropFurniture(const FacetEvidence& evidence,
                   const std::vector<Eigen::Vector3d>& around,
                   const FurnishedFloor& floor,
                   FacetChoice& choice);

/** @brief Returns the points of a room's floor: of its main plane, and of platforms,
 * steps, pits and ramps beside it; not of furniture.
 * @param ends points on which the air of the room ends below, as seen from above
 * @param around all points in and near the room
 * @param main plane of the floor
 * @param tolerance largest distance of a point from its plane, metres */
std::vector<int> floorPoints(const PointView& points,
                             const std::vector<int>& ends,
                             const std::vector<int>& around,
                             const PlanSlab& main,
                             double tolerance,
                             const Priors& priors);

} // namespace pcl::sedr
