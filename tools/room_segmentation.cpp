// SPDX-License-Identifier: BSD-3-Clause
#include "bytes/whole_file.h"
#include "picture_file.h"
#include "plan_file.h"
#include "progress.h"
#include "room_picture.h"
#include "rooms/building_file.h"
#include "run_tool.h"
#include "tool_cloud.h"
#include "tool_error.h"

#include "sedr_segmentation/src/scan/scan_check.h"
#include "sedr_segmentation/src/scan/scan_inclination.h"
#include <pcl/sedr_segmentation/room_segmentation.h>

#include <cmath>
#include <cstdio>
#include <numeric>
#include <vector>

using namespace pcl::sedr::tools;
using pcl::sedr::Building;
using pcl::sedr::LeftOut;
using pcl::sedr::LeftOutKind;
using pcl::sedr::RoomsAlongZ;

namespace {

using Segmentation = pcl::RoomSegmentation<pcl::PointXYZ>;

struct Settings {
  std::string input;
  std::string output;
  std::string building;
  std::string picture;
  bool trust_up = false;
  bool compress = false;
};

/** @brief Throws unless the input is a scan of rooms in metres with z up. */
void
checkScan(const Settings& settings, const ToolCloud& cloud, unsigned threads)
{
  const pcl::sedr::PointView points(*cloud.points);
  pcl::Indices all(cloud.size());
  std::iota(all.begin(), all.end(), 0);
  std::string problem = pcl::sedr::scanProblem(points, all);
  if (problem.empty() && !settings.trust_up) {
    problem = pcl::sedr::upProblem(points, all, RoomsAlongZ::NotLookedFor, 0, threads);
    if (problem.empty())
      problem = pcl::sedr::inclinationProblem(points, all, threads);
    if (!problem.empty())
      problem += ", or say --z-up if it is right as it is";
  }
  if (!problem.empty())
    throw ToolError("'" + cloud.path + "': " + problem, NothingFound);
}

void
segment(const Settings& settings, const ToolCloud& cloud, Segmentation& segmentation)
{
  const Progress progress("parting rooms");
  checkScan(settings, cloud, segmentation.getNumberOfThreads());
  segmentation.setInputCloud(cloud.points);
  std::vector<pcl::PointIndices> unused;
  if (!segmentation.segment(unused))
    throw ToolError("'" + cloud.path + "': " + segmentation.getErrorMessage(),
                    NothingFound);
}

/** @brief Rounds to millimetres and turns -0 into 0. */
double
rounded(double metres)
{
  return std::round(1000 * metres) / 1000 + 0.0;
}

void
print(const Building& building)
{
  std::printf("room storey   area m2  floor m  ceiling m  walls %%\n");
  for (const auto& room : building.rooms)
    std::printf("%4u %6u %9.2f %8.2f %10.2f %8.0f\n", room.id, room.storey, room.area,
                rounded(room.floor), rounded(room.ceiling), 100 * room.enclosure);
  for (const LeftOut& thing : building.left_out)
    if (thing.kind == LeftOutKind::Void)
      std::printf("left out: %.1f m2, %s\n", thing.area, thing.reason.c_str());
    else
      std::printf("left out: %.1f m2 at (%.1f, %.1f), %.1f to %.1f m, %s\n", thing.area,
                  thing.at.x(), thing.at.y(), rounded(thing.floor),
                  rounded(thing.ceiling), thing.reason.c_str());
}

int
run(const Settings& settings, Segmentation& segmentation)
{
  checkCloudOutput(settings.output);
  if (!settings.building.empty())
    checkJsonOutput(settings.building);
  checkPictureOutput(settings.picture);
  ToolCloud cloud = loadCloud(settings.input);
  segment(settings, cloud, segmentation);
  const Building& building = segmentation.getBuilding();
  setField(cloud.blob, "label", building.label_of);
  setField(cloud.blob, "room", building.room_of);
  saveCloud(settings.output, cloud,
            settings.compress ? PcdData::Compressed : PcdData::Binary);
  if (!settings.building.empty())
    writeWhole(settings.building,
               [&](std::ostream& stream) { stream << buildingToJson(building); });
  if (!settings.picture.empty())
    savePicture(settings.picture, drawRooms(building));
  print(building);
  return Done;
}

} // namespace

int
main(int argc, char** argv)
{
  Segmentation segmentation;
  Settings settings;
  double grid = segmentation.getGridSize();
  double area = segmentation.getMinimumArea();
  double headroom = segmentation.getHeadroom();
  double enclosure = segmentation.getMinimumEnclosure();
  double door = segmentation.getWidestDoor();
  double passage = segmentation.getWidestPassage();
  double step = segmentation.getStoreyStep();
  unsigned threads = segmentation.getNumberOfThreads();

  Options options(
      "pcl_room_segmentation",
      "Parts a thinned scan into rooms and storeys by its air, lists them, and labels "
      "the points of\nceilings 1, of floors 2, all others 0, each with the number of "
      "its room.");
  options.file("INPUT", settings.input, "PCD or PLY file, thinned, z up, metres");
  options.file("OUTPUT", settings.output, "PCD or PLY file to write");
  options.number("grid", grid, "m", "edge of a cell; air is looked for in larger ones",
                 Range::between(0.01, 1));
  options.number("min-area", area, "m2", "smallest room, with headroom",
                 Range::above(0));
  options.number("headroom", headroom, "m", "least height of a room", Range::above(0));
  options.number("min-enclosure", enclosure, "",
                 "share of a room's outline at which walls stand",
                 Range::between(0, 1));
  options.number("widest-door", door, "m",
                 "widest opening that jambs or a small lintel make a door",
                 Range::above(0));
  options.number("widest-passage", passage, "m",
                 "widest opening below a lintel that parts two rooms", Range::above(0));
  options.number("storey-step", step, "m",
                 "floors that differ by less are of one storey", Range::above(0));
  options.number("threads", threads, "", "threads to use, 0 = all processors");
  options.text("building", settings.building,
               "JSON file for rooms, storeys, doorways, stairs and what was left out");
  addPictureOption(options, settings.picture);
  options.flag(
      "z-up", settings.trust_up,
      "take z as up even if another axis seems to be, or the scan is inclined");
  options.flag("compress", settings.compress, "write PCD as binary_compressed");
  return runTool(options, argc, argv, [&] {
    segmentation.setGridSize(grid);
    segmentation.setMinimumArea(area);
    segmentation.setHeadroom(headroom);
    segmentation.setMinimumEnclosure(enclosure);
    segmentation.setWidestDoor(door);
    segmentation.setWidestPassage(passage);
    segmentation.setStoreyStep(step);
    segmentation.setNumberOfThreads(threads);
    return run(settings, segmentation);
  });
}
