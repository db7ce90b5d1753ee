// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief Returns the partition of places into rooms on which several partitions agree:
 * two sets of places are one room if more pairs of their places are in one room than in
 * two, counted over all partitions. Sets start as the places that have the same room in
 * every partition; those that agree most are joined first (average linkage). Of equally
 * many votes the first partition decides. A place without a room in a partition has no
 * vote there. O(places + sets squared), and far less where few sets share a room.
 * @param rooms of each partition the room of each place, from 0, negative for none
 * @return room of each place, any numbers from 0, -1 where no partition has one */
std::vector<std::int32_t>
agreedRooms(const std::vector<std::vector<std::int32_t>>& rooms);

} // namespace pcl::sedr
