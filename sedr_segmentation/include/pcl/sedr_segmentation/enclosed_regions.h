// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/region_selection.h>
#include <pcl/sedr_segmentation/room_segmentation.h>

#include <cstddef>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief The cells of those regions of a ceiling that were not kept, but are rooms:
 * furniture hides most of the floor, but walls that go up to the ceiling close them all
 * around, but for the width of a door. What is seen of another room through a door or a
 * window has no walls towards it.
 *
 * Regions smaller than a room, and such that have not even
 * RoomParameters::minimum_floor_share of their floor, are none. O(n) for each region
 * that is looked at.
 * @param map the regions of the ceiling `levels[ceiling]`, with cells as large as those
 * of the rooms
 * @param levels classified, the floors with cells
 * @param indices of all points: what walls are found in */
CellSet enclosedRegions(const RegionMap& map,
                        const std::vector<Level>& levels,
                        std::size_t ceiling,
                        const PointView& points,
                        const std::vector<int>& indices,
                        const RoomParameters& parameters);

} // namespace sedr
} // namespace pcl
