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

struct Settings : StageFiles {
  std::string building;
  bool trust_up = false;
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
  settings.check();
  if (!settings.building.empty())
    checkJsonOutput(settings.building);
  ToolCloud cloud = loadCloud(settings.input);
  segment(settings, cloud, segmentation);
  const Building& building = segmentation.getBuilding();
  setField(cloud.blob, "label", building.label_of);
  setField(cloud.blob, "room", building.room_of);
  settings.save(cloud);
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

  Options options(
      "pcl_room_segmentation",
      "Parts a thinned scan into rooms and storeys by its air, lists them, and labels "
      "the points of\nceilings 1, of floors 2, all others 0, each with the number of "
      "its room.");
  options.file("INPUT", settings.input, "PCD or PLY file, thinned, z up, metres");
  options.file("OUTPUT", settings.output, "PCD or PLY file to write");
  options.parameter(
      "grid", segmentation, &Segmentation::getGridSize, &Segmentation::setGridSize, "m",
      "edge of a cell; air is looked for in larger ones", Range::between(0.01, 1));
  options.parameter("min-area", segmentation, &Segmentation::getMinimumArea,
                    &Segmentation::setMinimumArea, "m2", "smallest room, with headroom",
                    Range::above(0));
  options.parameter("headroom", segmentation, &Segmentation::getHeadroom,
                    &Segmentation::setHeadroom, "m", "least height of a room",
                    Range::above(0));
  options.parameter("min-enclosure", segmentation, &Segmentation::getMinimumEnclosure,
                    &Segmentation::setMinimumEnclosure, "",
                    "share of a room's outline at which walls stand",
                    Range::between(0, 1));
  options.parameter("widest-door", segmentation, &Segmentation::getWidestDoor,
                    &Segmentation::setWidestDoor, "m",
                    "widest opening that jambs or a small lintel make a door",
                    Range::above(0));
  options.parameter("widest-passage", segmentation, &Segmentation::getWidestPassage,
                    &Segmentation::setWidestPassage, "m",
                    "widest opening below a lintel that parts two rooms",
                    Range::above(0));
  options.parameter("storey-step", segmentation, &Segmentation::getStoreyStep,
                    &Segmentation::setStoreyStep, "m",
                    "floors that differ by less are of one storey", Range::above(0));
  options.threads(segmentation);
  options.text("building", settings.building,
               "JSON file for rooms, storeys, doorways, stairs and what was left out");
  options.flag(
      "z-up", settings.trust_up,
      "take z as up even if another axis seems to be, or the scan is inclined");
  settings.addOptions(options);
  return runTool(options, argc, argv, [&] { return run(settings, segmentation); });
}
