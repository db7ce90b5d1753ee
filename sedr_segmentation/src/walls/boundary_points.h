// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_segmentation/ceiling_boundary_wall_growing.h>
#include <pcl/types.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief What is wrong with the options, a sentence; empty if nothing is. */
std::string problemOf(const BoundaryOptions& options);

/** @brief Writes the indices of the `k` points nearest to point `index`, itself among
 * them. Is called by several threads at a time. */
using NeighbourSearch =
    std::function<void(pcl::index_t index, unsigned int k, pcl::Indices& nearest)>;

/** @brief The finite ones of `indices`, sorted, each once. */
pcl::Indices finiteIndices(const PointView& points, const pcl::Indices& indices);

/** @brief The widest angle, radians, between successive directions in the x-y plane
 * from point `index` to its neighbours: pi on a straight rim, 3/2 pi on a protruding
 * corner, 2 pi where there is no direction at all. Neighbours straight above, below or
 * at the point have none.
 * @param[out] directions angles from the x axis, radians, ascending */
float widestGap(const PointView& points,
                pcl::index_t index,
                const pcl::Indices& neighbours,
                std::vector<float>& directions);

/** @brief The same of directions, angles in any order, which are sorted. */
float widestGap(std::vector<float>& directions);

/** @brief Those of `indices` (finite points, ascending) whose neighbours leave a gap
 * wider than the angle: the criterion of pcl::BoundaryEstimation with a vertical
 * normal. */
pcl::Indices boundaryPoints(const PointView& points,
                            const pcl::Indices& indices,
                            const NeighbourSearch& search,
                            const BoundaryOptions& options);

/** @brief How near is measured: in space, or in the x-y plane whatever the heights. */
enum class Nearness { Space, Plan };

/** @brief The same with a search of its own over `indices`, which may come in any order
 * and hold NaN points. O(n log n) in time; points within the slab cost a fraction of
 * those on its rim. */
pcl::Indices boundaryPoints(const PointView& points,
                            const pcl::Indices& indices,
                            Nearness nearness,
                            const BoundaryOptions& options);

} // namespace pcl::sedr
