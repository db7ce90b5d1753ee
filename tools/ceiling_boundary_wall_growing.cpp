// SPDX-License-Identifier: BSD-3-Clause
#include "labelled_points.h"
#include "picture_file.h"
#include "progress.h"
#include "rooms/file_rooms.h"
#include "run_tool.h"
#include "tool_cloud.h"
#include "tool_error.h"
#include "wall_picture.h"

#include <pcl/sedr_segmentation/ceiling_boundary_wall_growing.h>

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

using namespace pcl::sedr::tools;
using pcl::sedr::StructureLabel;

namespace {

using Growing = pcl::CeilingBoundaryWallGrowing<pcl::PointXYZ>;

constexpr double territory_cell = 0.05; // metres

struct Settings : StageFiles {
  std::string boundary_output;
  std::optional<double> slice_height;
};

/** @brief The input of wall growing in one room. */
struct Room {
  std::uint32_t id = 0; ///< 0 in a file without rooms
  pcl::Indices ceiling;
  pcl::Indices floor;
  pcl::Indices details;
  pcl::Indices candidates;
};

/** @brief Returns the points of a room, and candidates without a room. */
Room
pointsOfRoom(const ToolCloud& cloud, std::uint32_t id)
{
  Room room;
  room.id = id;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const bool is_own = id == 0 || cloud.room[i] == id;
    const auto index = static_cast<pcl::index_t>(i);
    const auto label = static_cast<StructureLabel>(cloud.label[i]);
    if (label == StructureLabel::Other || label == StructureLabel::Wall) {
      if (is_own || cloud.room[i] == 0)
        room.candidates.push_back(index);
    }
    else if (!is_own)
      continue;
    else if (label == StructureLabel::Ceiling)
      room.ceiling.push_back(index);
    else if (label == StructureLabel::Floor)
      room.floor.push_back(index);
    else if (label == StructureLabel::Detail)
      room.details.push_back(index);
  }
  return room;
}

/** @brief Returns the given slice height, or else the minimum height of the details. */
double
sliceHeight(const Settings& settings, const ToolCloud& cloud, const Room& room)
{
  if (settings.slice_height)
    return *settings.slice_height;
  double lowest = std::numeric_limits<double>::quiet_NaN();
  for (const auto i : room.details)
    lowest = std::fmin(lowest, (*cloud.points)[static_cast<std::size_t>(i)].z);
  return lowest;
}

RoomWalls
growIn(const Settings& settings,
       const ToolCloud& cloud,
       const Room& room,
       Growing& growing)
{
  growing.setInputCloud(cloud.points);
  growing.setIndices(pcl::make_shared<const pcl::Indices>(room.candidates));
  growing.setCeilingIndices(room.ceiling);
  growing.setFloorIndices(room.floor);
  growing.setDetailIndices(room.details);
  growing.setSliceHeight(sliceHeight(settings, cloud, room));
  pcl::PointIndices walls_and_details;
  if (!growing.segment(walls_and_details))
    throw ToolError((room.id > 0 ? "room " + std::to_string(room.id) + ": " : "") +
                        growing.getErrorMessage(),
                    NothingFound);
  return roomWallsOf(growing, room.id);
}

/** @brief Takes all points in a room's territory as its wall candidates, if room
 * segmentation has labelled the rooms. No room can then claim another room's walls. */
void
takeTerritories(const ToolCloud& cloud, unsigned threads, std::vector<Room>& rooms)
{
  const std::vector<FileRoom> known = roomsOf(cloud);
  const auto at = territoryOf(known, cloud, territory_cell)
                      .roomsAt(pcl::sedr::PointView(*cloud.points), threads);
  std::map<std::uint32_t, pcl::Indices> candidates;
  for (std::size_t i = 0; i < at.size(); ++i)
    if (at[i] >= 0)
      candidates[known[static_cast<std::size_t>(at[i])].id].push_back(
          static_cast<pcl::index_t>(i));
  for (Room& room : rooms)
    room.candidates = std::move(candidates[room.id]);
}

double
squareDistanceToBoundary(const ToolCloud& cloud,
                         pcl::index_t index,
                         const RoomWalls& found)
{
  const auto plan = [&](pcl::index_t i) {
    return (*cloud.points)[static_cast<std::size_t>(i)].getVector3fMap().head<2>();
  };
  float least = std::numeric_limits<float>::infinity();
  for (const auto i : found.boundary)
    least = std::min(least, (plan(i) - plan(index)).squaredNorm());
  return least;
}

/** @brief Labels the walls. A point that two rooms claim goes to the nearer boundary.
 * @return number of wall points */
std::size_t
labelWalls(const std::vector<RoomWalls>& rooms, ToolCloud& cloud)
{
  std::replace(cloud.label.begin(), cloud.label.end(),
               static_cast<std::uint32_t>(StructureLabel::Wall),
               static_cast<std::uint32_t>(StructureLabel::Other));
  std::vector<const RoomWalls*> owner(cloud.size(), nullptr);
  for (const auto& found : rooms)
    for (const auto i : found.walls) {
      if (cloud.label[static_cast<std::size_t>(i)] != 0)
        continue;
      auto& now = owner[static_cast<std::size_t>(i)];
      if (!now || squareDistanceToBoundary(cloud, i, found) <
                      squareDistanceToBoundary(cloud, i, *now))
        now = &found;
    }
  std::size_t walls = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (owner[i]) {
      cloud.label[i] = static_cast<std::uint32_t>(StructureLabel::Wall);
      cloud.room[i] = owner[i]->room > 0 ? owner[i]->room : cloud.room[i];
      ++walls;
    }
  setField(cloud.blob, "label", cloud.label);
  if (cloud.has_room)
    setField(cloud.blob, "room", cloud.room);
  return walls;
}

void
saveBoundary(const Settings& settings,
             const std::vector<RoomWalls>& rooms,
             const ToolCloud& cloud)
{
  pcl::Indices boundary;
  for (const auto& found : rooms)
    boundary.insert(boundary.end(), found.boundary.begin(), found.boundary.end());
  std::sort(boundary.begin(), boundary.end());
  boundary.erase(std::unique(boundary.begin(), boundary.end()), boundary.end());
  ToolCloud points;
  points.blob = selectRows(cloud.blob, boundary);
  points.points = cloud.points;
  settings.save(points, settings.boundary_output);
}

int
run(const Settings& settings, Growing& growing)
{
  settings.check();
  if (!settings.boundary_output.empty())
    checkCloudOutput(settings.boundary_output);
  ToolCloud cloud = loadCloud(settings.input);
  std::vector<Room> rooms_of_file;
  for (const auto id : ceilingRooms(cloud))
    rooms_of_file.push_back(pointsOfRoom(cloud, id));
  if (isByRooms(cloud))
    takeTerritories(cloud, growing.getNumberOfThreads(), rooms_of_file);
  std::vector<RoomWalls> rooms;
  for (const Room& room : rooms_of_file) {
    const Progress progress(
        "growing walls" +
        (room.id > 0 ? " of room " + std::to_string(room.id) : std::string()));
    rooms.push_back(growIn(settings, cloud, room, growing));
  }
  const std::size_t walls = labelWalls(rooms, cloud);
  if (walls == 0)
    throw ToolError("no point of '" + cloud.path + "' is within " +
                        std::to_string(growing.getDistanceThreshold()) +
                        " m of the boundary of the ceiling in plan",
                    NothingFound);
  settings.save(cloud);
  if (!settings.boundary_output.empty())
    saveBoundary(settings, rooms, cloud);
  if (!settings.picture.empty())
    savePicture(settings.picture,
                drawWalls(rooms, pcl::sedr::PointView(*cloud.points)));
  say(std::to_string(walls) + " of " + std::to_string(cloud.size()) +
      " points are walls, of " + std::to_string(rooms.size()) +
      (rooms.size() == 1 ? " room" : " rooms"));
  return Done;
}

} // namespace

int
main(int argc, char** argv)
{
  Growing growing;
  Settings settings;

  Options options(
      "pcl_ceiling_boundary_wall_growing",
      "Labels the walls of every room, label 3: points below the boundary of its "
      "ceiling, label 1.\nUses the floor, label 2, and details, label 4, where the "
      "file has them; walls already labelled are looked for anew.");
  options.file("INPUT", settings.input,
               "PCD or PLY file with labels, and rooms if several");
  options.file("OUTPUT", settings.output, "PCD or PLY file to write");
  options.parameter("distance", growing, &Growing::getDistanceThreshold,
                    &Growing::setDistanceThreshold, "m",
                    "farthest a wall point is from the boundary in plan",
                    Range::above(0));
  options.parameter("angle", growing, &Growing::getAngleThreshold,
                    &Growing::setAngleThreshold, "degrees",
                    "widest gap between directions to the neighbors of an inner point",
                    Range::between(1, 359), M_PI / 180);
  options.parameter("neighbors", growing, &Growing::getNumberOfNeighbors,
                    &Growing::setNumberOfNeighbors, "",
                    "neighbors looked at; fewer find the rims of smaller columns",
                    Range::atLeast(3));
  options.optionalNumber(
      "slice-height", settings.slice_height, "m",
      "height above which walls grow from the ceiling, below from the floor",
      "the lowest detail of the room; no slice without details");
  options.parameter("min-support", growing, &Growing::getMinimumSupport,
                    &Growing::setMinimumSupport, "",
                    "share of the height that must be occupied below a rim, 0 = any",
                    Range::between(0, 1));
  options.threads(growing);
  options.text("boundary", settings.boundary_output,
               "file for the boundary points alone");
  settings.addOptions(options);
  return runTool(options, argc, argv, [&] { return run(settings, growing); });
}
