// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tool_cloud.h"

#include "sedr_segmentation/src/plan/room_shares.h"
#include "sedr_segmentation/src/rooms/room_planes.h"
#include <pcl/sedr_filters/point_types.h>
#include <pcl/sedr_segmentation/building.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::sedr::tools {

/** @brief Returns the rows with a label. Throws ToolError if there are none. */
pcl::Indices requireLabel(const ToolCloud& cloud, StructureLabel label);

/** @brief Returns the mean height of all floor points, label 2, for rooms whose floor
 * was not seen. Throws ToolError if none is finite. */
double meanFloorHeight(const ToolCloud& cloud);

/** @brief Returns whether rows with a label have room numbers. */
bool hasRooms(const ToolCloud& cloud, StructureLabel label = StructureLabel::Ceiling);

/** @brief Returns the owners of the rows by the field `owner` of pcl_room_segmentation;
 * none if the file has no such field, or no rooms. */
std::vector<PointOwner> ownersOf(const ToolCloud& cloud);

/** @brief Gives rows a label and a room. */
void setLabel(const pcl::Indices& rows,
              StructureLabel label,
              std::uint32_t room,
              ToolCloud& cloud);

/** @brief Writes label and, if the cloud has it, room to the fields of the cloud. */
void storeLabels(ToolCloud& cloud);

/** @brief The rows of a room in a labelled file, without those that are not finite. */
struct LabelledRoom : RoomEvidence {
  std::uint32_t id = 0; ///< 0: a file without rooms
};

/** @brief Returns the rooms that have a ceiling, by number; a file without numbers is
 * one room. Other rows belong to the room in which, or next to which, they lie. Throws
 * ToolError without a finite point of a ceiling.
 * @param grid_size edge of the cells of the plan, metres */
std::vector<LabelledRoom> labelledRooms(const ToolCloud& cloud, double grid_size);

/** @brief Fits the main plane of a room's ceiling, or of its floor, which must have
 * points. */
PlanSlab ceilingOf(const LabelledRoom& room,
                   const ToolCloud& cloud,
                   const RoomPlaneParameters& parameters);
PlanSlab floorOf(const LabelledRoom& room,
                 const ToolCloud& cloud,
                 const RoomPlaneParameters& parameters);

/** @brief Throws ToolError unless the file is a scan of rooms in metres. If z is not
 * trusted, throws as well if another direction is up, or the scan inclined, and warns
 * if that may be. */
void checkScan(const ToolCloud& cloud, bool trust_up);

/** @brief Writes a building as JSON: heights and gaps of rooms, storeys, links, stairs.
 */
std::string buildingToJson(const Building& building);

/** @brief Reads the output of buildingToJson(), but for the gaps. Throws ToolError on
 * failure. */
Building loadBuilding(const std::string& path);

} // namespace pcl::sedr::tools
