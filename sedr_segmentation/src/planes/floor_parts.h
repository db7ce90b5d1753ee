// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/priors.h>

#include <vector>

namespace pcl::sedr {

/** @brief Returns whether furniture may be as large as a level surface above a floor:
 * the lower the smaller; and higher than tables no deeper than cupboards.
 * @param depth twice the area by the length of the outline: of a long strip its width
 */
bool isAsFurniture(double area, double depth, double height, const Priors& priors);

/** @brief Returns the points of a room's floor: of its main plane, and of platforms,
 * steps, pits and ramps beside it; not of furniture.
 *
 * The surface on which the room's air ends is labelled by planes. A piece beside the
 * floor is part of it if risers, walls and creases close its rim, no floor is seen
 * below it, and it is reached by a step or larger than furniture.
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
