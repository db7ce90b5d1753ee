// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tool_cloud.h"

#include "sedr_segmentation/src/plan/room_territory.h"
#include "sedr_segmentation/src/rooms/room_planes.h"

#include <cstdint>
#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief What a file says of a room: rows with its number, by their label. Rows that
 * are not finite are left out. */
struct FileRoom {
  std::uint32_t id = 0;
  pcl::Indices ceiling; ///< label 1
  pcl::Indices floor;   ///< label 2
  pcl::Indices details; ///< label 4
};

/** @brief Whether room segmentation, or a stage after it, wrote this file: ceilings and
 * floors have the number of a room. */
bool isByRooms(const ToolCloud& cloud);

/** @brief The rooms that have a ceiling, by their numbers. O(n log n). */
std::vector<FileRoom> roomsOf(const ToolCloud& cloud);

/** @brief The main plane of the floor of a room, which must have points. */
PlanSlab floorOf(const FileRoom& room,
                 const ToolCloud& cloud,
                 const RoomPlaneParameters& parameters);

/** @brief The main plane of the ceiling of a room. */
PlanSlab ceilingOf(const FileRoom& room,
                   const ToolCloud& cloud,
                   const RoomPlaneParameters& parameters);

/** @brief Which room each place belongs to, of whatever storey, by its place in
 * `rooms`. What cannot be told is a ToolError. */
RoomTerritory territoryOf(const std::vector<FileRoom>& rooms,
                          const ToolCloud& cloud,
                          double grid_size);

} // namespace tools
} // namespace sedr
} // namespace pcl
