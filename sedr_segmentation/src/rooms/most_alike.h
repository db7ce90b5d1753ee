// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_segmentation/building.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief Returns how alike two partitions of the same points into rooms are: the
 * number of rooms that match, divided by the mean number of rooms (their F1). Two rooms
 * match if what they have in common is more than half of what they have together, so a
 * room has one match at most. 1 if all match, 0 if none does. Points should be thinned,
 * since they are counted. O(n + rooms of a times rooms of b).
 * @param a room of each point, 0 for none
 * @param b likewise */
double likeness(const std::vector<std::uint32_t>& a,
                const std::vector<std::uint32_t>& b);

/** @brief Returns the number of the building whose rooms are the most like those of
 * all: what most of them agree on. Each counts itself, so one without rooms is only
 * taken if all are. The first of equal ones, 0 if there is none. O(buildings squared
 * times points). */
std::size_t mostAlike(const std::vector<Building>& buildings);

} // namespace pcl::sedr
