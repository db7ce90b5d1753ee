// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tool_cloud.h"

#include "sedr_segmentation/src/rooms/room_planes.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace pcl::sedr::tools {

/** @brief Input of detail detection for one room. */
struct DetailRoom {
  std::uint32_t id = 0;  ///< 0: a file without rooms
  pcl::Indices ceilings; ///< of all heights, label 1
  pcl::Indices floors;   ///< of all heights, label 2
  pcl::Indices around;   ///< surrounding points of any label
  pcl::Indices ceiling;  ///< main ceiling
  pcl::Indices floor;    ///< main floor
  double floor_height = std::numeric_limits<double>::quiet_NaN(); ///< of `floor`
  bool is_parted = false; ///< room segmentation assigned all its ceilings
};

/** @brief Returns the rooms of a file. If room segmentation wrote it, each room has its
 * own points; else points belong to the room with the nearest ceiling in plan. Throws
 * ToolError if a room has no finite ceiling point. */
std::vector<DetailRoom> detailRooms(const ToolCloud& cloud,
                                    double grid_size,
                                    const RoomPlaneParameters& parameters);

} // namespace pcl::sedr::tools
