// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../air/voxel_columns.h"

#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_segmentation/building.h>

#include <vector>

namespace pcl::sedr {

/** @brief Finds the flights of a building: chains of level patches of the scan with air
 * above, each a step higher than the one before and next to it, from a floor or landing
 * up. Of all chains the one of the greatest log-odds against patches of furniture is
 * taken, by dynamic programming from below, then the best of what is left. Flights are
 * added to the stairs that lead to where they lead, and others as stairs of their own.
 * O(columns + points) and O(p^2) for p patches that are no floor.
 * @param fine columns of the points, of at most 0.1 m; else nothing is found
 * @param[in,out] building its rooms and storeys, and links between them as stairs */
void addFlights(const PointView& points,
                const std::vector<int>& indices,
                const VoxelColumns& fine,
                Building& building);

} // namespace pcl::sedr
