// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tool_cloud.h"

#include "sedr_segmentation/src/rooms/room_planes.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief What the details of the ceiling of one room are looked for in. */
struct DetailRoom {
  std::uint32_t id = 0;  ///< 0: a file without rooms
  pcl::Indices ceilings; ///< of all heights, label 1
  pcl::Indices floors;   ///< of all heights, label 2
  pcl::Indices around;   ///< points in its surroundings, with whatever label
  pcl::Indices ceiling;  ///< the main one
  pcl::Indices floor;    ///< likewise
  double floor_height = std::numeric_limits<double>::quiet_NaN(); ///< that of `floor`
  bool is_parted = false; ///< room segmentation says that all its ceilings are its own
};

/** @brief The rooms of a file. Where room segmentation wrote it, each with its own
 * points; else points are of the room whose ceiling is nearest in plan. A room without
 * a finite ceiling point is a ToolError. */
std::vector<DetailRoom> detailRooms(const ToolCloud& cloud,
                                    double grid_size,
                                    const RoomPlaneParameters& parameters);

} // namespace tools
} // namespace sedr
} // namespace pcl
