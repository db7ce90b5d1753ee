// SPDX-License-Identifier: BSD-3-Clause
#include "labelled_points.h"
#include "picture_file.h"
#include "progress.h"
#include "rooms/detail_rooms.h"
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

/** @brief Finds the details of one room. */
pcl::Indices
analyse(Analysis& analysis,
        const ToolCloud& cloud,
        const DetailRoom& room,
        double floor_height)
{
  analysis.setInputCloud(cloud.points);
  analysis.setIndices(pcl::make_shared<const pcl::Indices>(room.around));
  analysis.setCeilingIndices(room.ceiling);
  analysis.setFloorIndices(room.floor);
  analysis.setFloorHeight(floor_height);
  pcl::PointIndices details;
  if (!analysis.segment(details))
    throw ToolError((room.id > 0 ? "room " + std::to_string(room.id) + ": " : "") +
                        analysis.getErrorMessage(),
                    NothingFound);
  return details.indices;
}

void
tell(const Analysis& analysis, const DetailRoom& room, const pcl::Indices& details)
{
  char text[160];
  const std::size_t regions = analysis.getRegionSizes().size();
  if (details.empty())
    std::snprintf(text, sizeof text, "room %u: no details", room.id);
  else
    std::snprintf(
        text, sizeof text, "room %u: %zu points of %zu %s, all above %.2f m; %s%d",
        room.id, details.size(), regions, regions == 1 ? "detail" : "details",
        analysis.getSliceHeight(),
        analysis.getTrial() > 0 ? "enclosed in trial " : "enclosed in no trial, ",
        analysis.getTrial());
  say(text);
}

/** @brief Labels the points of a room. Planes that are neither the main ceiling or
 * floor nor a detail become other. If the file comes from room segmentation, all other
 * ceilings of a room are details. */
void
label(const DetailRoom& room, const pcl::Indices& details, ToolCloud& cloud)
{
  const auto set = [&](const pcl::Indices& indices, StructureLabel to,
                       std::uint32_t id) {
    for (const auto i : indices) {
      cloud.label[static_cast<std::size_t>(i)] = static_cast<std::uint32_t>(to);
      cloud.room[static_cast<std::size_t>(i)] = id;
    }
  };
  if (room.is_parted)
    set(room.ceilings, StructureLabel::Detail, room.id);
  else
    set(room.ceilings, StructureLabel::Other, 0);
  set(room.floors, StructureLabel::Other, 0);
  set(room.floor, StructureLabel::Floor, room.id);
  set(room.ceiling, StructureLabel::Ceiling, room.id);
  set(details, StructureLabel::Detail, room.id);
}

int
run(const Settings& settings, Analysis& analysis)
{
  settings.check();
  ToolCloud cloud = loadCloud(settings.input);
  std::replace(cloud.label.begin(), cloud.label.end(),
               static_cast<std::uint32_t>(StructureLabel::Detail),
               static_cast<std::uint32_t>(StructureLabel::Other));
  pcl::sedr::RoomPlaneParameters parameters;
  parameters.tolerance = analysis.getDistanceThreshold();
  parameters.seed = analysis.getSeed();
  parameters.threads = analysis.getNumberOfThreads();
  std::vector<DetailRoom> rooms;
  // For rooms whose own floor is hidden.
  const double height =
      settings.floor_height
          ? *settings.floor_height
          : meanFloorHeight(cloud, "--floor-height would stand for them");
  std::vector<pcl::Indices> found;
  std::vector<RoomSlices> slices;
  {
    const Progress progress("looking at slices");
    rooms = detailRooms(cloud, analysis.getGridSize(), parameters);
    for (const DetailRoom& room : rooms) {
      const bool is_known = !settings.floor_height && !room.floor.empty();
      found.push_back(
          analyse(analysis, cloud, room, is_known ? room.floor_height : height));
      tell(analysis, room, found.back());
      slices.push_back({room.id, analysis.getAnalysis(), room.around, room.ceiling});
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
  Settings settings;

  Options options(
      "pcl_grid_slice_detail",
      "Labels the details of every room's ceiling, soffits, beams and "
      "recesses, label 4.\nUses "
      "ceilings, label 1, and floors, label 2; details already labelled "
      "are looked for anew.\n"
      "Of several ceilings of a room the largest keeps label 1, the others "
      "become details or 0; of\n"
      "several floors the lowest below a tenth of the ceilings keeps label "
      "2, the others become 0.\n"
      "In a file that pcl_room_segmentation has parted into rooms all other "
      "ceilings become details.");
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
  options.parameter(
      "trials", analysis, &Analysis::getTrials, &Analysis::setTrials, "",
      "slices at 1/4; then at 1/2; then at 1/8 and 3/8 of the height below the ceiling",
      Range::between(1, 3));
  options.parameter("thickness", analysis, &Analysis::getSliceThickness,
                    &Analysis::setSliceThickness, "m", "of a slice", Range::above(0));
  options.parameter(
      "min-island", analysis, &Analysis::getMinimumIslandArea,
      &Analysis::setMinimumIslandArea, "m2",
      "what the ceiling encloses all around and is smaller is a lamp or a vent",
      Range::atLeast(0));
  options.optionalNumber("floor-height", settings.floor_height, "m", "z of the floor",
                         "the mean of the room's floor points");
  options.seed(analysis);
  options.threads(analysis);
  settings.addOptions(options);
  return runTool(options, argc, argv, [&] { return run(settings, analysis); });
}
