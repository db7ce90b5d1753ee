// SPDX-License-Identifier: BSD-3-Clause
#include "labelled_points.h"
#include "picture_file.h"
#include "progress.h"
#include "rooms/labelled_rooms.h"
#include "run_tool.h"
#include "slice_picture.h"
#include "tool_cloud.h"
#include "tool_error.h"

#include <pcl/sedr_segmentation/grid_slice_detail.h>

#include <algorithm>
#include <cstdio>

using namespace pcl::sedr::tools;
using pcl::sedr::StructureLabel;

namespace {

using Analysis = pcl::GridSliceDetail<pcl::PointXYZ>;

struct Settings : StageFiles {
  std::optional<double> floor_height;
};

/** @brief The main ceiling and floor of a room, and its details. */
struct FoundDetails {
  pcl::Indices ceiling;
  pcl::Indices floor;
  pcl::Indices details;
};

/** @brief Finds the details of one room.
 * @param common_height of the floor, where the room's own was not seen, metres */
FoundDetails
analyse(const Settings& settings,
        const ToolCloud& cloud,
        const LabelledRoom& room,
        double common_height,
        Analysis& analysis)
{
  const pcl::sedr::PointView points(*cloud.points);
  pcl::sedr::RoomPlaneParameters parameters;
  parameters.tolerance = analysis.getDistanceThreshold();
  FoundDetails found;
  found.ceiling = pointsOn(points, room.ceiling, ceilingOf(room, cloud, parameters),
                           parameters.tolerance);
  double height = settings.floor_height.value_or(common_height);
  if (!room.floor.empty()) {
    const pcl::sedr::PlanSlab plane = floorOf(room, cloud, parameters);
    found.floor = pointsOn(points, room.floor, plane, parameters.tolerance);
    const pcl::sedr::CellGrid grid(analysis.getGridSize());
    const pcl::sedr::CellSet scope(grid, points, room.ceiling);
    if (!settings.floor_height)
      height = plane.heightAt(grid.centre(scope[scope.size() / 2]));
  }
  analysis.setInputCloud(cloud.points);
  analysis.setIndices(pcl::make_shared<const pcl::Indices>(room.around));
  analysis.setCeilingIndices(found.ceiling);
  analysis.setFloorIndices(found.floor);
  analysis.setFloorHeight(height);
  pcl::PointIndices details;
  if (!analysis.segment(details))
    throw ToolError("room " + std::to_string(room.id) + ": " +
                        analysis.getErrorMessage(),
                    NothingFound);
  found.details = details.indices;
  return found;
}

void
tell(const Analysis& analysis, const LabelledRoom& room, const FoundDetails& found)
{
  char text[160];
  const std::size_t regions = analysis.getRegionSizes().size();
  if (found.details.empty())
    std::snprintf(text, sizeof text, "room %u: no details", room.id);
  else
    std::snprintf(
        text, sizeof text, "room %u: %zu points of %zu %s, all above %.2f m; %s%d",
        room.id, found.details.size(), regions, regions == 1 ? "detail" : "details",
        analysis.getSliceHeight(),
        analysis.getTrial() > 0 ? "enclosed in trial " : "enclosed in no trial, ",
        analysis.getTrial());
  say(text);
}

/** @brief Labels the points of a room: other ceilings are details, other floors 0. */
void
label(const LabelledRoom& room, const FoundDetails& found, ToolCloud& cloud)
{
  setLabel(room.ceiling, StructureLabel::Detail, room.id, cloud);
  setLabel(room.floor, StructureLabel::Other, 0, cloud);
  setLabel(found.floor, StructureLabel::Floor, room.id, cloud);
  setLabel(found.ceiling, StructureLabel::Ceiling, room.id, cloud);
  setLabel(found.details, StructureLabel::Detail, room.id, cloud);
}

int
run(const Settings& settings, Analysis& analysis)
{
  settings.check();
  ToolCloud cloud = loadCloud(settings.input);
  std::replace(cloud.label.begin(), cloud.label.end(),
               static_cast<std::uint32_t>(StructureLabel::Detail),
               static_cast<std::uint32_t>(StructureLabel::Other));
  const std::vector<LabelledRoom> rooms = labelledRooms(cloud, analysis.getGridSize());
  const double height =
      settings.floor_height
          ? *settings.floor_height
          : meanFloorHeight(cloud, "--floor-height would stand for them");
  std::vector<FoundDetails> found;
  std::vector<RoomSlices> slices;
  {
    const Progress progress("looking at slices");
    for (const LabelledRoom& room : rooms) {
      found.push_back(analyse(settings, cloud, room, height, analysis));
      tell(analysis, room, found.back());
      slices.push_back(
          {room.id, analysis.getAnalysis(), room.around, found.back().ceiling});
    }
  }
  for (std::size_t r = 0; r < rooms.size(); ++r)
    label(rooms[r], found[r], cloud);
  setField(cloud.blob, "label", cloud.label);
  if (cloud.has_room)
    setField(cloud.blob, "room", cloud.room);
  settings.save(cloud);
  if (!settings.picture.empty())
    savePicture(settings.picture,
                drawSlices(slices, pcl::sedr::PointView(*cloud.points),
                           analysis.getGridSize()));
  return Done;
}

} // namespace

int
main(int argc, char** argv)
{
  Analysis analysis;
  analysis.setNumberOfThreads(0);
  Settings settings;
  Options options(
      "pcl_grid_slice_detail",
      "Labels the details of every room's ceiling, soffits, beams and recesses, label "
      "4.\nUses ceilings, label 1, and floors, label 2; details already labelled are "
      "looked for anew.\nOf several ceilings of a room the largest keeps label 1, the "
      "others become details; of several\nfloors the lowest that a tenth of their "
      "points have keeps label 2, the others become 0.");
  options.file("INPUT", settings.input,
               "PCD or PLY file with labels, and rooms if several");
  options.file("OUTPUT", settings.output, "PCD or PLY file to write");
  options.parameter("grid", analysis, &Analysis::getGridSize, &Analysis::setGridSize,
                    "m", "edge of a cell", Range::between(0.01, 1));
  options.parameter("distance", analysis, &Analysis::getDistanceThreshold,
                    &Analysis::setDistanceThreshold, "m",
                    "farthest a point is from the plane of the ceiling",
                    Range::above(0));
  options.parameter("min-cells", analysis, &Analysis::getMinimumCells,
                    &Analysis::setMinimumCells, "cells", "smallest detail");
  options.optionalNumber("floor-height", settings.floor_height, "m", "z of the floor",
                         "the mean of the room's floor points");
  settings.addOptions(options);
  return runTool(options, argc, argv, [&] { return run(settings, analysis); });
}
