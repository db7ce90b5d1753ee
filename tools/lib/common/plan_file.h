// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tool_cloud.h"

#include "sedr_filters/src/plan/plan_surfaces.h"
#include <pcl/sedr_filters/plan_editor.h>
#include <pcl/sedr_filters/straightening.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pcl::sedr::tools {

/** @brief Reads a floor plan. Throws ToolError on failure, including a plan without
 * rooms. */
std::shared_ptr<const Floorplan> loadFloorplan(const std::string& path);

/** @brief Returns the origin of the coordinates in a floor plan or a report.json, if it
 * states one. Throws ToolError if the file is no JSON, or the origin is not three
 * numbers. */
std::optional<Origin> statedPlanOrigin(const std::string& path);

/** @brief The same; 0, 0, 0 if none is stated. */
Origin planOrigin(const std::string& path);

/** @brief Returns the tilted walls in a plan file that loadFloorplan() has read. Throws
 * ToolError if they are invalid. */
WallTilts planTilts(const std::string& path);

/** @brief Returns the text of a plan file. */
std::string planText(const std::string& path);

/** @brief Returns the names of rooms in a plan file. */
RoomNames planNames(const std::string& path);

/** @brief Returns the maximum thickness of a wall that a plan file states, metres, or
 * the default. Throws ToolError if it is invalid. */
double planMaxWall(const std::string& path);

/** @brief Assigns rooms to points of a file that has none: the plan's room that
 * contains the point, or else the nearest. Does nothing if any labelled point has a
 * room. */
void giveRooms(const Floorplan& plan, ToolCloud& cloud);

/** @brief Writes points of the structure to the same number of rows of `blob`: x, y, z,
 * normal_x, normal_y, normal_z, label and room. Missing fields are added. */
void setSurfacePoints(pcl::PCLPointCloud2& blob,
                      const std::vector<SurfacePoint>& points);

} // namespace pcl::sedr::tools
