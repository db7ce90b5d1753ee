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

/** @brief A floor plan, and what else its file tells. */
struct PlanFile {
  std::string text;
  std::shared_ptr<const Floorplan> plan;
  Origin origin; ///< of the coordinates; 0, 0, 0 if none is stated
  WallTilts tilts;
  RoomNames names;
  double max_wall = 0; ///< maximum thickness of a wall, metres

  /** @brief Takes names, tilts and thickness over to the settings of a drawing or
   * building model. */
  template <typename SettingsT>
  void describe(SettingsT& settings) const
  {
    settings.names = names;
    settings.tilts = tilts;
    settings.max_wall = max_wall;
  }
};

/** @brief Reads a floor plan. Throws ToolError on failure, including a plan without
 * rooms. */
PlanFile loadPlan(const std::string& path);

/** @brief Returns the JSON of a plan after its rooms, and what refers to them, were
 * changed; all else stays. Warns of tilts that are lost with a room's walls. */
std::string
changedPlanJson(const PlanFile& before, const Floorplan& after, const RoomNames& names);

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
