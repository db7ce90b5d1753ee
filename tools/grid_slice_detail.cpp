// SPDX-License-Identifier: BSD-3-Clause
#include "labelled_points.h"
#include "picture_file.h"
#include "progress.h"
#include "run_tool.h"
#include "slice_picture.h"
#include "tool_cloud.h"
#include "tool_error.h"

#include <pcl/sedr_filters/plane_fit.h>
#include <pcl/sedr_segmentation/grid_slice_detail.h>
#include <pcl/sedr_segmentation/horizontal_levels.h>
#include <pcl/sedr_segmentation/room_territory.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace pcl::sedr::tools;
using pcl::sedr::StructureLabel;

namespace {

using Analysis = pcl::GridSliceDetail<pcl::PointXYZ>;

struct Settings {
  std::string input;
  std::string output;
  double floor_height = 0;
  bool has_floor_height = false;
  std::string picture;
  bool compress = false;
};

/** @brief What the details of one room are looked for in. */
struct Room {
  std::uint32_t id = 0;  ///< 0: a file without rooms
  pcl::Indices ceilings; ///< of all heights
  pcl::Indices floors;   ///< of all heights
  pcl::Indices around;   ///< points in its surroundings, with whatever label
  std::size_t cells = 0; ///< below its ceilings
};

/** @brief The rooms with their ceilings. */
std::vector<Room>
roomsWithCeilings(const ToolCloud& cloud)
{
  const pcl::sedr::PointView points(*cloud.points);
  std::vector<Room> rooms;
  for (const auto id : ceilingRooms(cloud)) {
    Room room;
    room.id = id;
    for (const auto i : cloud.withLabel(StructureLabel::Ceiling)) {
      const auto at = static_cast<std::size_t>(i);
      if ((id == 0 || cloud.room[at] == id) && points.isFinite(at))
        room.ceilings.push_back(i);
    }
    if (room.ceilings.empty())
      throw ToolError("no ceiling point of room " + std::to_string(id) + " is finite",
                      NothingFound);
    rooms.push_back(std::move(room));
  }
  return rooms;
}

/** @brief Shares out all points: each belongs to the room whose ceiling is nearest in
 * plan. */
void
shareOut(const Analysis& analysis, const ToolCloud& cloud, std::vector<Room>& rooms)
{
  const pcl::sedr::CellGrid grid(analysis.getGridSize());
  const pcl::sedr::PointView points(*cloud.points);
  std::vector<pcl::sedr::CellSet> scopes;
  for (auto& room : rooms) {
    scopes.emplace_back(grid, points, room.ceilings);
    room.cells = scopes.back().size();
  }
  const pcl::sedr::RoomTerritory territory(grid, scopes);
  if (!territory.problem().empty())
    throw ToolError(territory.problem());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const std::int32_t at = territory.roomAt(points[i]);
    if (at < 0)
      continue;
    Room& room = rooms[static_cast<std::size_t>(at)];
    room.around.push_back(static_cast<pcl::index_t>(i));
    if (cloud.label[i] == static_cast<std::uint32_t>(StructureLabel::Floor))
      room.floors.push_back(static_cast<pcl::index_t>(i));
  }
}

/** @brief Those of the points that lie on a plane. */
pcl::Indices
onSlab(const pcl::sedr::PointView& points,
       const pcl::Indices& indices,
       const pcl::sedr::PlanSlab& slab,
       double band)
{
  pcl::Indices on;
  for (const auto i : indices)
    if (std::abs(pcl::sedr::distanceAbove(slab, points[static_cast<std::size_t>(i)])) <=
        band)
      on.push_back(i);
  return on;
}

/** @brief Of the room's ceilings the largest; the others are looked at anew. */
pcl::Indices
mainCeiling(const Analysis& analysis, const ToolCloud& cloud, const Room& room)
{
  const pcl::sedr::PointView points(*cloud.points);
  const double band = analysis.getDistanceThreshold();
  const auto slab = pcl::sedr::findSlab(points, room.ceilings, band,
                                        pcl::sedr::LevelParameters().maximum_tilt,
                                        analysis.getSeed());
  return onSlab(points, room.ceilings, slab, band);
}

/** @brief Of the room's floors the lowest that is seen below a tenth of its ceilings:
 * higher ones are platforms or table tops. All of them if none is so large. */
pcl::Indices
mainFloor(const Analysis& analysis, const ToolCloud& cloud, const Room& room)
{
  const pcl::sedr::PointView points(*cloud.points);
  pcl::sedr::LevelParameters parameters;
  parameters.tolerance = analysis.getDistanceThreshold();
  parameters.cell_size = analysis.getGridSize();
  parameters.seed = analysis.getSeed();
  parameters.minimum_area = 0.1 * static_cast<double>(room.cells) *
                            parameters.cell_size * parameters.cell_size;
  const auto levels = pcl::sedr::findLevels(points, room.floors, parameters);
  return levels.empty()
             ? room.floors
             : onSlab(points, room.floors, levels.front().slab, parameters.tolerance);
}

/** @brief What was found in one room. */
struct Found {
  pcl::Indices ceiling; ///< the main one
  pcl::Indices floor;   ///< likewise
  pcl::Indices details;
};

Found
analyse(Analysis& analysis,
        const ToolCloud& cloud,
        const Room& room,
        double floor_height)
{
  const auto shared = [](const pcl::Indices& indices) {
    return pcl::make_shared<const pcl::Indices>(indices);
  };
  Found found;
  found.ceiling = mainCeiling(analysis, cloud, room);
  found.floor = mainFloor(analysis, cloud, room);
  analysis.setInputCloud(cloud.points);
  analysis.setIndices(shared(room.around));
  analysis.setCeilingIndices(shared(found.ceiling));
  analysis.setFloorIndices(shared(found.floor));
  analysis.setFloorHeight(floor_height);
  pcl::PointIndices details;
  if (!analysis.segment(details))
    throw ToolError((room.id > 0 ? "room " + std::to_string(room.id) + ": " : "") +
                        analysis.getErrorMessage(),
                    NothingFound);
  found.details = details.indices;
  return found;
}

void
tell(const Analysis& analysis, const Room& room, const Found& found)
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

/** @brief Labels what was found in a room. What was taken for a ceiling or floor, and
 * is neither the main one nor a detail, is other. */
void
label(const Room& room, const Found& found, ToolCloud& cloud)
{
  const auto set = [&](const pcl::Indices& indices, StructureLabel to,
                       std::uint32_t id) {
    for (const auto i : indices) {
      cloud.label[static_cast<std::size_t>(i)] = static_cast<std::uint32_t>(to);
      cloud.room[static_cast<std::size_t>(i)] = id;
    }
  };
  set(room.ceilings, StructureLabel::Other, 0);
  set(room.floors, StructureLabel::Other, 0);
  set(found.floor, StructureLabel::Floor, room.id);
  set(found.ceiling, StructureLabel::Ceiling, room.id);
  set(found.details, StructureLabel::Detail, room.id);
}

int
run(const Settings& settings, Analysis& analysis)
{
  checkCloudOutput(settings.output);
  checkPictureOutput(settings.picture);
  ToolCloud cloud = loadCloud(settings.input);
  std::replace(cloud.label.begin(), cloud.label.end(),
               static_cast<std::uint32_t>(StructureLabel::Detail),
               static_cast<std::uint32_t>(StructureLabel::Other));
  std::vector<Room> rooms = roomsWithCeilings(cloud);
  // For rooms whose own floor was not seen at all.
  const double height =
      settings.has_floor_height
          ? settings.floor_height
          : meanFloorHeight(cloud, "--floor-height would stand for them");
  std::vector<Found> found;
  std::vector<RoomSlices> slices;
  {
    const Progress progress("looking at slices");
    shareOut(analysis, cloud, rooms);
    for (const Room& room : rooms) {
      const bool is_known = !settings.has_floor_height && !room.floors.empty();
      found.push_back(analyse(analysis, cloud, room, is_known ? std::nan("") : height));
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
  saveCloud(settings.output, cloud,
            settings.compress ? PcdData::Compressed : PcdData::Binary);
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
  double grid = analysis.getGridSize();
  double distance = analysis.getDistanceThreshold();
  std::size_t cells = analysis.getMinimumCells();
  int trials = analysis.getTrials();
  double thickness = analysis.getSliceThickness();
  double island = analysis.getMinimumIslandArea();
  std::uint64_t seed = analysis.getSeed();
  unsigned threads = analysis.getNumberOfThreads();

  Options options("pcl_grid_slice_detail",
                  "Labels the details of every room's ceiling, soffits, beams and "
                  "recesses, label 4.\nUses "
                  "ceilings, label 1, and floors, label 2; details already labelled "
                  "are looked for anew.\n"
                  "Of several ceilings of a room the largest keeps label 1, the others "
                  "become details or 0; of\n"
                  "several floors the lowest below a tenth of the ceilings keeps label "
                  "2, the others become 0.");
  options.file("INPUT", settings.input,
               "PCD or PLY file with labels, and rooms if several");
  options.file("OUTPUT", settings.output, "PCD or PLY file to write");
  options.number("grid", grid, "m", "edge of a cell", Range::between(0.01, 1));
  options.number("distance", distance, "m",
                 "farthest a point is from the plane of the ceiling", Range::above(0));
  options.number("min-cells", cells, "cells", "smallest detail");
  options.number(
      "trials", trials, "",
      "slices at 1/4; then at 1/2; then at 1/8 and 3/8 of the height below the ceiling",
      Range::between(1, 3));
  options.number("thickness", thickness, "m", "of a slice", Range::above(0));
  options.number(
      "min-island", island, "m2",
      "what the ceiling encloses all around and is smaller is a lamp or a vent",
      Range::atLeast(0));
  options.optionalNumber("floor-height", settings.floor_height,
                         settings.has_floor_height, "m", "z of the floor",
                         "the mean of the room's floor points");
  options.number("seed", seed, "", "seed of the random samples", Range::atLeast(0));
  options.number("threads", threads, "", "threads to use, 0 = all processors");
  addPictureOption(options, settings.picture);
  options.flag("compress", settings.compress, "write PCD as binary_compressed");
  return runTool(options, argc, argv, [&] {
    analysis.setGridSize(grid);
    analysis.setDistanceThreshold(distance);
    analysis.setMinimumCells(cells);
    analysis.setTrials(trials);
    analysis.setSliceThickness(thickness);
    analysis.setMinimumIslandArea(island);
    analysis.setSeed(seed);
    analysis.setNumberOfThreads(threads);
    return run(settings, analysis);
  });
}
