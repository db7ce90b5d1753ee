// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tool_cloud.h"

#include "sedr_filters/src/plan/plan_surfaces.h"
#include <pcl/sedr_filters/floorplan_io.h>

#include <optional>
#include <string>
#include <vector>

namespace pcl::sedr::tools {

/** @brief Reads a floor plan. Throws ToolError on failure, including a plan without
 * rooms. */
PlanDocument loadPlan(const std::string& path);

/** @brief Returns the origin of the coordinates in a floor plan or a report.json, if it
 * states one. Throws ToolError if the file is no JSON, or the origin is not three
 * numbers. */
std::optional<Origin> statedPlanOrigin(const std::string& path);

/** @brief Returns the bytes of a file. Throws ToolError if it cannot be read. */
std::string textOfFile(const std::string& path);

/** @brief Assigns rooms to points of a file that has none: the plan's room that
 * contains the point, or else the nearest. Does nothing if any labelled point has a
 * room. */
void giveRooms(const Floorplan& plan, ToolCloud& cloud);

/** @brief Writes points of the structure to the same number of rows of `blob`: x, y, z,
 * normal_x, normal_y, normal_z, label and room. Missing fields are added. */
void setSurfacePoints(pcl::PCLPointCloud2& blob,
                      const std::vector<SurfacePoint>& points);

} // namespace pcl::sedr::tools
