// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_segmentation/ceiling_boundary_wall_growing.h>
#include <pcl/types.h>

#include <string>

namespace pcl::sedr {

/** @brief What is wrong with the options, a sentence; empty if nothing is. */
std::string problemOf(const BoundaryOptions& options);

/** @brief The finite ones of `indices`, sorted, each once. */
pcl::Indices finiteIndices(const PointView& points, const pcl::Indices& indices);

/** @brief How near is measured: in space, or in the x-y plane whatever the heights. */
enum class Nearness { Space, Plan };

/** @brief Those of `indices`, ascending, whose nearest neighbours among them leave a
 * gap between their directions in the x-y plane that is wider than the angle: the
 * criterion of pcl::BoundaryEstimation with a vertical normal. Neighbours straight
 * above, below or at a point have no direction. NaN points are left out. O(n log n) in
 * time; points within the slab cost a fraction of those on its rim. */
pcl::Indices boundaryPoints(const PointView& points,
                            const pcl::Indices& indices,
                            Nearness nearness,
                            const BoundaryOptions& options);

} // namespace pcl::sedr
