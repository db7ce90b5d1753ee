// SPDX-License-Identifier: BSD-3-Clause
#include "floor_picture.h"
#include "labelled_points.h"
#include "picture_file.h"
#include "progress.h"
#include "rooms/file_rooms.h"
#include "run_tool.h"
#include "tool_cloud.h"
#include "tool_error.h"

#include "sedr_filters/src/plan/room_map.h"
#include <pcl/sedr_filters/floor_projection_recovery.h>
#include <pcl/sedr_filters/impl/floor_recovery.h>

#include <algorithm>
#include <map>
#include <memory>

using namespace pcl::sedr::tools;
using pcl::sedr::StructureLabel;

namespace {

struct Settings : StageFiles {
  double grid = 0;
  std::optional<double> height;
  bool remove = false;
};

/** @brief The points of one room by label. */
struct RoomPoints {
  pcl::Indices floor;
  pcl::Indices ceiling;
  pcl::Indices detail;
  pcl::sedr::PlanSlab plane; ///< of its floor, if the file assigns floors to rooms
  bool has_plane = false;
};

/** @brief The recovered floors of all rooms. */
struct Recovered {
  std::vector<bool> removed; ///< per row of the input
  pcl::Indices sources;      ///< rows that the new floor points copy
  std::vector<Eigen::Vector3f> points;
  std::vector<std::uint32_t> rooms;
  std::vector<FloorCells> cells; ///< for the picture
};

/** @brief Splits the points by room; all get room 0 if no ceiling point has one. Floor
 * and detail points without a room get that of the ceiling above or beside them, also
 * in `cloud.room`. */
std::map<std::uint32_t, RoomPoints>
splitRooms(const Settings& settings, ToolCloud& cloud)
{
  const pcl::Indices floor = cloud.withLabel(StructureLabel::Floor);
  const pcl::Indices ceiling = requireLabel(cloud, StructureLabel::Ceiling);
  const pcl::Indices detail = cloud.withLabel(StructureLabel::Detail);
  const bool has_rooms =
      std::any_of(ceiling.begin(), ceiling.end(), [&](pcl::index_t i) {
        return cloud.room[static_cast<std::size_t>(i)] != 0;
      });
  const pcl::sedr::RoomMap map(pcl::sedr::CellGrid(settings.grid),
                               pcl::sedr::PointView(*cloud.points), cloud.room, ceiling,
                               detail);
  std::map<std::uint32_t, RoomPoints> rooms;
  if (isByRooms(cloud))
    for (const FileRoom& room : roomsOf(cloud))
      if (!room.floor.empty()) {
        rooms[room.id].plane = floorOf(room, cloud, pcl::sedr::RoomPlaneParameters());
        rooms[room.id].has_plane = true;
      }
  const auto share = [&](const pcl::Indices& indices, pcl::Indices RoomPoints::*part) {
    for (const auto i : indices) {
      auto& room = cloud.room[static_cast<std::size_t>(i)];
      if (room == 0)
        room = map.roomOver(i);
      (rooms[has_rooms ? room : 0].*part).push_back(i);
    }
  };
  share(ceiling, &RoomPoints::ceiling);
  share(detail, &RoomPoints::detail);
  share(floor, &RoomPoints::floor);
  return rooms;
}

void
recoverRoom(const Settings& settings,
            const ToolCloud& cloud,
            std::uint32_t room,
            const RoomPoints& points,
            double common_height,
            Recovered& result)
{
  if (points.ceiling.empty()) { // no ceiling above: outside
    for (const auto i : points.floor)
      result.removed[static_cast<std::size_t>(i)] = true;
    const pcl::sedr::CellSet outside(pcl::sedr::CellGrid(settings.grid),
                                     pcl::sedr::PointView(*cloud.points), points.floor);
    result.cells.push_back({settings.grid, {}, {}, outside});
    return;
  }
  pcl::FloorProjectionRecovery<pcl::PointXYZ> recovery(true);
  recovery.setInputCloud(cloud.points);
  recovery.setIndices(pcl::make_shared<const pcl::Indices>(points.floor));
  recovery.setCeilingIndices(points.ceiling);
  recovery.setDetailIndices(points.detail);
  recovery.setGridSize(settings.grid);
  const auto level = std::make_shared<pcl::ModelCoefficients>();
  level->values = {0, 0, 1, -static_cast<float>(common_height)};
  if (points.has_plane && !settings.height)
    for (int k = 0; k < 4; ++k)
      level->values[static_cast<std::size_t>(k)] =
          static_cast<float>(points.plane.plane[k]);
  const auto kept = pcl::sedr::recoverFloor(pcl::sedr::CellGrid(settings.grid),
                                            pcl::sedr::PointView(*cloud.points),
                                            points.floor, points.ceiling, points.detail)
                        .kept;
  if (settings.height || points.has_plane || kept.empty())
    recovery.setFloorCoefficients(level);
  pcl::PointCloud<pcl::PointXYZ> floor;
  recovery.filter(floor);
  if (!recovery.getErrorMessage().empty())
    throw ToolError(recovery.getErrorMessage());

  result.cells.push_back(floorCellsOf(recovery));
  for (const auto i : *recovery.getRemovedIndices())
    result.removed[static_cast<std::size_t>(i)] = true;
  const auto& sources = recovery.getProjectedIndices();
  for (std::size_t i = floor.size() - recovery.getNumberOfProjected(); i < floor.size();
       ++i) {
    result.sources.push_back(sources[i]);
    result.points.push_back(floor[i].getVector3fMap());
    result.rooms.push_back(room);
  }
}

/** @brief Writes the recovered points to the fields and rows of the cloud. */
void
apply(const Settings& settings, const Recovered& result, ToolCloud& cloud)
{
  const std::size_t before = cloud.size();
  pcl::Indices stay;
  for (std::size_t i = 0; i < before; ++i) {
    if (result.removed[i])
      cloud.label[i] = cloud.room[i] = 0;
    if (!result.removed[i] || !settings.remove)
      stay.push_back(static_cast<pcl::index_t>(i));
  }
  cloud.label.resize(before + result.points.size(),
                     static_cast<std::uint32_t>(StructureLabel::Floor));
  cloud.room.insert(cloud.room.end(), result.rooms.begin(), result.rooms.end());
  appendRows(cloud.blob, pcl::PCLPointCloud2(cloud.blob), result.sources);
  setCoordinates(cloud.blob, before, result.points);
  setField(cloud.blob, "label", cloud.label);
  setField(cloud.blob, "room", cloud.room);
  for (const auto& [name, up] : std::map<std::string, float>{{"normal_x", 0.f},
                                                             {"normal_y", 0.f},
                                                             {"normal_z", 1.f}}) {
    auto values = floatField(cloud.blob, name);
    if (values.empty())
      continue;
    std::fill(values.begin() + static_cast<std::ptrdiff_t>(before), values.end(), up);
    setField(cloud.blob, name, values);
  }
  if (!settings.remove)
    return;
  for (std::size_t i = before; i < cloud.label.size(); ++i)
    stay.push_back(static_cast<pcl::index_t>(i));
  cloud.blob = selectRows(cloud.blob, stay);
}

int
run(const Settings& settings)
{
  settings.check();
  ToolCloud cloud = loadCloud(settings.input);
  const auto rooms = splitRooms(settings, cloud);
  // For rooms whose own floor is hidden.
  const double height = settings.height
                            ? *settings.height
                            : meanFloorHeight(cloud, "--height would stand for them");
  Recovered result;
  result.removed.assign(cloud.size(), false);
  {
    const Progress progress("completing the floor");
    for (const auto& room : rooms)
      recoverRoom(settings, cloud, room.first, room.second, height, result);
  }
  apply(settings, result, cloud);
  settings.save(cloud);
  if (!settings.picture.empty())
    savePicture(settings.picture, drawFloor(result.cells));
  say(std::to_string(result.points.size()) + " points projected, " +
      std::to_string(std::count(result.removed.begin(), result.removed.end(), true)) +
      " floor points removed");
  return Done;
}

} // namespace

int
main(int argc, char** argv)
{
  Settings settings;
  settings.grid = pcl::FloorProjectionRecovery<pcl::PointXYZ>().getGridSize();

  Options options(
      "pcl_floor_projection_recovery",
      "Completes the floor (label 2) from the ceiling and its details (labels 1 and 4) "
      "room by\nroom, and takes floor points outside the rooms for other (label 0).");
  options.file("INPUT", settings.input,
               "PCD or PLY file with field 'label', perhaps 'room'");
  options.file("OUTPUT", settings.output, "PCD or PLY file to write");
  options.number("grid", settings.grid, "m", "edge of a cell", Range::above(0));
  options.optionalNumber("height", settings.height, "m", "z of the projected points",
                         "the mean of the room's floor points");
  options.flag("remove", settings.remove, "leave floor points outside the rooms out");
  settings.addOptions(options);
  return runTool(options, argc, argv, [&] { return run(settings); });
}
