// SPDX-License-Identifier: BSD-3-Clause
#include "bytes/whole_file.h"
#include "rooms/labelled_rooms.h"
#include "run_tool.h"
#include "stage_pictures.h"
#include "tool_error.h"

#include <pcl/sedr_segmentation/room_segmentation.h>

#include <cmath>
#include <cstdio>

using namespace pcl::sedr::tools;
using pcl::sedr::Building;
using pcl::sedr::LeftOut;
using pcl::sedr::LeftOutKind;

namespace {

using Segmentation = pcl::RoomSegmentation<pcl::PointXYZ>;

struct Settings : StageFiles {
  std::string building;
  bool trust_up = false;
  bool scan_axes = false;
};

void
segment(const Settings& settings, const ToolCloud& cloud, Segmentation& segmentation)
{
  const Progress progress("parting rooms");
  checkScan(cloud, settings.trust_up);
  segmentation.setInputCloud(cloud.points);
  segmentation.setInBuildingFrame(!settings.scan_axes);
  std::vector<pcl::PointIndices> unused;
  if (!segmentation.segment(unused))
    throw ToolError("'" + cloud.path + "': " + segmentation.getErrorMessage(),
                    NothingFound);
}

/** @brief Returns the room that owns each point; 0 for those that no wall or slab of a
 * room is near. */
std::vector<std::uint32_t>
ownersOf(const Building& building)
{
  std::vector<std::uint32_t> owners;
  for (const pcl::sedr::PointOwner& owner : building.owner_of)
    owners.push_back(owner.beyond ? 0 : owner.room);
  return owners;
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
  for (const pcl::sedr::RoomDoubt& doubt : building.doubts) {
    const auto [room, other] = doubt.rooms;
    std::printf("in doubt: %.1f m2 at (%.1f, %.1f), %.0f %% likely ", doubt.area,
                doubt.at.x(), doubt.at.y(), 100 * doubt.chance);
    if (room == other)
      std::printf("a room apart from %u\n", room);
    else
      std::printf("of one room, %u and %u\n", room, other);
  }
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
    checkOutput(settings.building, "a building", {".json"});
  ToolCloud cloud = loadCloud(settings.input);
  segment(settings, cloud, segmentation);
  const Building& building = segmentation.getBuilding();
  setField(cloud.blob, "label", building.label_of);
  setField(cloud.blob, "room", building.room_of);
  setField(cloud.blob, "owner", ownersOf(building));
  saveCloud(settings.output, cloud);
  if (!settings.building.empty())
    writeWhole(settings.building, buildingToJson(building));
  settings.picture.write([&] { return drawRooms(building); });
  print(building);
  return Done;
}

} // namespace

int
main(int argc, char** argv)
{
  Segmentation segmentation;
  segmentation.setNumberOfThreads(0);
  Settings settings;
  Options options(
      "pcl_room_segmentation",
      "Parts a thinned scan into rooms and storeys by its air, lists them, and labels "
      "the points of\nceilings 1, of floors 2, all others 0, each with the number of "
      "its room.");
  settings.declare(options, ", thinned, z up, metres");
  options.parameter(
      "grid", segmentation, &Segmentation::getGridSize, &Segmentation::setGridSize, "m",
      "edge of a cell; air is looked for in larger ones", Range::between(0.01, 1));
  options.parameter("min-area", segmentation, &Segmentation::getMinimumArea,
                    &Segmentation::setMinimumArea, "m2", "smallest room, with headroom",
                    Range::above(0));
  options.text("building", settings.building,
               "JSON file for storeys, links of rooms and stairs");
  options.flag(
      "scan-axes", settings.scan_axes,
      "lay the grid along the axes of the scan, as the points were thinned, not "
      "of the building");
  options.flag(
      "z-up", settings.trust_up,
      "take z as up even if another axis seems to be, or the scan is inclined");
  return runTool(options, argc, argv, [&] { return run(settings, segmentation); });
}
