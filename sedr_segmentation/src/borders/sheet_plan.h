// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../sheets/sheet_fit.h"
#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/point_view.h>

#include <Eigen/Core>

#include <vector>

namespace pcl::sedr {

/** @brief Gives a room its ceiling, or its floor: the largest facet is the main one,
 * others lie over it, with borders where facets meet, at steps, and at the room's
 * walls. Details make way.
 * @param points those that the sheet was fitted to
 * @param risers points of what is vertical between its facets; may be empty */
void giveCeiling(const FacetSheet& sheet,
                 const std::vector<Eigen::Vector3d>& points,
                 const std::vector<Eigen::Vector3d>& risers,
                 PlanRoom& room,
                 bool is_floor = false);

/** @brief The points of a scan between the heights of two facets, near where these may
 * step, and off the walls: of the riser between them, and of the lower one.
 * @param indices those of the scan's points that count; empty: all. O(n). */
std::vector<Eigen::Vector3d> pointsOfRisers(const FacetSheet& sheet,
                                            const PointView& scan,
                                            const std::vector<int>& indices);

} // namespace pcl::sedr
