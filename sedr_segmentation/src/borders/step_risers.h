// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/point_view.h>

#include <Eigen/Core>

#include <vector>

namespace pcl::sedr {

struct FacetSheet;

/** @brief The points of a scan between the heights of two facets, near where these may
 * step, and off the walls: most are of the riser between them.
 * @param indices those of the scan's points that count; empty: all. O(n). */
std::vector<Eigen::Vector3d> pointsOfRisers(const FacetSheet& sheet,
                                            const PointView& scan,
                                            const std::vector<int>& indices);

} // namespace pcl::sedr
