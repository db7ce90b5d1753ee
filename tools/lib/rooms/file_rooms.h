// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tool_cloud.h"

#include "sedr_segmentation/src/plan/room_territory.h"
#include "sedr_segmentation/src/rooms/room_planes.h"

#include <cstdint>
#include <vector>

namespace pcl::sedr::tools {

/** @brief Rows of a room in a file, by label. Non-finite rows are omitted. */
struct FileRoom {
  std::uint32_t id = 0;
  pcl::Indices ceiling; ///< label 1
  pcl::Indices floor;   ///< label 2
  pcl::Indices details; ///< label 4
};

/** @brief Returns whether room segmentation or a later stage wrote this file: ceilings
 * and floors have room numbers. */
bool isByRooms(const ToolCloud& cloud);

/** @brief Returns the rooms that have a ceiling, by number. O(n log n). */
std::vector<FileRoom> roomsOf(const ToolCloud& cloud);

/** @brief Fits the main plane of the floor of a room, which must have points. */
PlanSlab floorOf(const FileRoom& room,
                 const ToolCloud& cloud,
                 const RoomPlaneParameters& parameters);

/** @brief Fits the main plane of the ceiling of a room. */
PlanSlab ceilingOf(const FileRoom& room,
                   const ToolCloud& cloud,
                   const RoomPlaneParameters& parameters);

/** @brief Assigns each place to a room of any storey, by index in `rooms`. Throws
 * ToolError on failure. */
RoomTerritory territoryOf(const std::vector<FileRoom>& rooms,
                          const ToolCloud& cloud,
                          double grid_size);

} // namespace pcl::sedr::tools
