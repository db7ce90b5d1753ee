// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tool_cloud.h"

#include "sedr_segmentation/src/rooms/room_planes.h"

#include <cstdint>
#include <vector>

namespace pcl::sedr::tools {

/** @brief The rows of a room in a labelled file, without those that are not finite. */
struct LabelledRoom {
  std::uint32_t id = 0; ///< 0: a file without rooms
  pcl::Indices ceiling; ///< label 1, of all heights
  pcl::Indices floor;   ///< label 2, of all heights
  pcl::Indices details; ///< label 4
  pcl::Indices around;  ///< rows of any label in the room and at its walls
};

/** @brief Returns whether room segmentation or a later stage wrote this file: ceilings
 * and floors have room numbers. */
bool isByRooms(const ToolCloud& cloud);

/** @brief Returns the rooms that have a ceiling, by number; a file without numbers is
 * one room. Other rows belong to the room in which, or next to which, they lie. Throws
 * ToolError without a finite point of a ceiling.
 * @param grid_size edge of the cells of the plan, metres */
std::vector<LabelledRoom>
labelledRooms(const ToolCloud& cloud, double grid_size, unsigned threads = 0);

/** @brief Fits the main plane of a room's ceiling, or of its floor, which must have
 * points. */
PlanSlab ceilingOf(const LabelledRoom& room,
                   const ToolCloud& cloud,
                   const RoomPlaneParameters& parameters);
PlanSlab floorOf(const LabelledRoom& room,
                 const ToolCloud& cloud,
                 const RoomPlaneParameters& parameters);

/** @brief Gives rows a label and a room. */
void setLabel(const pcl::Indices& rows,
              StructureLabel label,
              std::uint32_t room,
              ToolCloud& cloud);

} // namespace pcl::sedr::tools
