// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tool_cloud.h"

#include "sedr_filters/src/plan/plan_surfaces.h"
#include <pcl/sedr_filters/floorplan.h>

#include <memory>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief Reads a floor plan. What is wrong, no room in it too, is a ToolError of one
 * sentence. */
std::shared_ptr<const Floorplan> loadFloorplan(const std::string& path);

/** @brief What the places of a floor plan, or those of a report.json, are counted from.
 */
Origin planOrigin(const std::string& path);

/** @brief Throws a ToolError if no file can be written to `path`, or if its name does
 * not end in .json, so that no scan is overwritten. To be asked before the work. */
void checkJsonOutput(const std::string& path);

/** @brief Rooms of the points in a file that has none: that of the plan that holds the
 * point or is nearest to it. Where any labelled point has a room, nothing is
 * changed. */
void giveRooms(const Floorplan& plan, ToolCloud& cloud);

/** @brief Writes points of the structure to the rows of `blob`, as many: x, y, z, and
 * the fields normal_x, normal_y, normal_z, label and room, which are added where
 * missing. */
void setSurfacePoints(pcl::PCLPointCloud2& blob,
                      const std::vector<SurfacePoint>& points);

} // namespace tools
} // namespace sedr
} // namespace pcl
