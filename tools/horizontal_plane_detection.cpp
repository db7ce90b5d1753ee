// SPDX-License-Identifier: BSD-3-Clause
#include "picture_file.h"
#include "rooms/building_file.h"
#include "rooms/labelled_rooms.h"
#include "run_tool.h"
#include "tool_error.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>

using namespace pcl::sedr::tools;
using pcl::sedr::LevelKind;
using pcl::sedr::PointView;
using pcl::sedr::StructureLabel;

namespace {

using Detection = pcl::HorizontalPlaneDetection<pcl::PointXYZ>;
using Planes = std::vector<pcl::HorizontalPlane>;

/** Radians. PCL's factor is slightly larger and would exceed a limit of 45 degrees. */
constexpr double degree = M_PI / 180;

struct Settings : StageFiles {
  std::string building;
  bool trust_up = false;
  bool whole = false;
};

/** @brief Adds the ceiling that the building says was hidden: copies of a row of the
 * room's ceiling with a new position. */
void
addHiddenCeiling(const pcl::sedr::Building& building,
                 const pcl::sedr::BuildingRoom& known,
                 const LabelledRoom& room,
                 const pcl::sedr::PlanSlab& plane,
                 const pcl::sedr::CellGrid& grid,
                 ToolCloud& cloud)
{
  const pcl::sedr::CellSet seen(grid, PointView(*cloud.points), room.ceiling);
  const std::vector<Eigen::Vector3f> places =
      hiddenCeiling(known.columns, building.grid, grid, seen, plane);
  const std::size_t before = cloud.size();
  cloud.blob +=
      selectRows(cloud.blob, pcl::Indices(places.size(), room.ceiling.front()));
  setCoordinates(cloud.blob, before, places);
  for (const auto& place : places)
    cloud.points->push_back({place.x(), place.y(), place.z()});
  cloud.label.resize(cloud.points->size(),
                     static_cast<std::uint32_t>(StructureLabel::Ceiling));
  cloud.room.resize(cloud.points->size(), room.id);
}

/** @brief Labels ceilings and floors in a file with rooms, as the chain does; returns
 * its planes. Ceiling points keep their label, floor points on the plane as well. */
Planes
planesByRoom(const Settings& settings, const Detection& detection, ToolCloud& cloud)
{
  pcl::sedr::RoomPlaneParameters parameters;
  parameters.tolerance = detection.getDistanceThreshold();
  parameters.maximum_tilt = detection.getMaximumTilt();
  parameters.threads = detection.getNumberOfThreads();
  const pcl::sedr::CellGrid grid(detection.getGridSize());
  pcl::sedr::Building building;
  if (!settings.building.empty())
    building = loadBuilding(settings.building);
  const std::vector<LabelledRoom> rooms = labelledRooms(cloud, grid.size());
  std::fill(cloud.label.begin(), cloud.label.end(), 0);
  std::fill(cloud.room.begin(), cloud.room.end(), 0);
  Planes planes;
  for (const LabelledRoom& room : rooms) {
    const auto known = std::find_if(building.rooms.begin(), building.rooms.end(),
                                    [&](const auto& r) { return r.id == room.id; });
    const bool is_known = known != building.rooms.end();
    const PointView points(*cloud.points);
    const auto add = [&](const pcl::Indices& sheet, LevelKind kind, double height) {
      const pcl::sedr::PlanSlab plane = mainPlane(points, sheet, height, parameters);
      planes.push_back(listedPlane(kind, plane,
                                   pointsOn(points, sheet, plane, parameters.tolerance),
                                   points, grid));
      return plane;
    };
    const auto ceiling =
        add(room.ceiling, LevelKind::Ceiling,
            is_known ? known->ceiling : ceilingLevel(points, room.ceiling));
    setLabel(room.ceiling, StructureLabel::Ceiling, room.id, cloud);
    if (!room.floor.empty()) {
      add(room.floor, LevelKind::Floor,
          is_known ? known->floor : floorLevel(points, room.floor));
      setLabel(planes.back().inliers.indices, StructureLabel::Floor, room.id, cloud);
    }
    if (is_known)
      addHiddenCeiling(building, *known, room, ceiling, grid, cloud);
  }
  return planes;
}

const char*
nameOf(LevelKind kind)
{
  return kind == LevelKind::Ceiling ? "ceiling"
         : kind == LevelKind::Floor ? "floor"
                                    : "other";
}

/** @brief Returns a sentence on the missing ceiling or floor of some planes. */
std::string
missingKind(const Planes& planes, double room_height)
{
  const auto count = [&](LevelKind kind) {
    return std::to_string(
        std::count_if(planes.begin(), planes.end(),
                      [&](const auto& plane) { return plane.kind == kind; }));
  };
  return "of " + std::to_string(planes.size()) + " horizontal planes " +
         count(LevelKind::Ceiling) + " are ceilings and " + count(LevelKind::Floor) +
         " floors; a ceiling needs a floor at least " + std::to_string(room_height) +
         " m below it";
}

/** @brief Labels ceilings and floors in a file without rooms; returns its planes. */
Planes
planesOfAll(const Settings& settings, Detection& detection, ToolCloud& cloud)
{
  if (!settings.building.empty())
    throw ToolError("--building is of no use without rooms, '" + settings.input +
                    "' is looked at as a whole");
  checkScan(cloud, settings.trust_up);
  Planes planes;
  detection.setInputCloud(cloud.points);
  if (!detection.segment(planes))
    throw ToolError(detection.getErrorMessage(), NothingFound);
  for (auto& plane : planes) // tops of walls just below a ceiling
    if (plane.area < detection.getMinimumArea())
      plane.kind = LevelKind::Other;
  std::map<LevelKind, double> areas;
  for (const auto& plane : planes)
    areas[plane.kind] += plane.area;
  if (!(areas[LevelKind::Ceiling] > 0 && areas[LevelKind::Floor] > 0))
    throw ToolError(missingKind(planes, detection.getMinimumRoomHeight()),
                    NothingFound);
  std::fill(cloud.label.begin(), cloud.label.end(), 0);
  std::fill(cloud.room.begin(), cloud.room.end(), 0);
  for (const auto& plane : planes)
    if (plane.kind != LevelKind::Other)
      setLabel(plane.inliers.indices,
               plane.kind == LevelKind::Ceiling ? StructureLabel::Ceiling
                                                : StructureLabel::Floor,
               0, cloud);
  return planes;
}

void
print(const Planes& planes)
{
  std::printf("kind     height m   area m2  tilt deg  residual cm   inliers\n");
  for (const auto& plane : planes)
    std::printf("%-7s %9.3f %9.2f %9.2f %12.2f %9zu\n", nameOf(plane.kind),
                std::round(1000 * plane.height) / 1000 + 0.0, plane.area,
                std::acos(std::min(1.0, plane.slab.plane[2])) / degree,
                100 * plane.residual, plane.inliers.indices.size());
}

int
run(const Settings& settings, Detection& detection)
{
  settings.check();
  ToolCloud cloud = loadCloud(settings.input);
  Planes planes;
  {
    const Progress progress("finding planes");
    planes =
        !settings.whole && hasRooms(cloud) && hasRooms(cloud, StructureLabel::Floor)
            ? planesByRoom(settings, detection, cloud)
            : planesOfAll(settings, detection, cloud);
  }
  storeLabels(cloud);
  settings.save(cloud);
  print(planes);
  return Done;
}

} // namespace

int
main(int argc, char** argv)
{
  Detection detection;
  detection.setNumberOfThreads(0);
  Settings settings;
  Options options(
      "pcl_horizontal_plane_detection",
      "Finds the horizontal planes of a thinned scan, lists them, and labels the "
      "points of ceilings 1,\nof floors 2, all others 0. A file that "
      "pcl_room_segmentation has parted into rooms is looked\nat room by room; rooms "
      "of another file are set to 0.");
  settings.declare(options, ", z up, metres");
  options.parameter("distance", detection, &Detection::getDistanceThreshold,
                    &Detection::setDistanceThreshold, "m",
                    "farthest a point is from its plane", Range::above(0));
  options.parameter("grid", detection, &Detection::getGridSize, &Detection::setGridSize,
                    "m", "edge of the cells that areas are counted in",
                    Range::between(0.01, 1));
  options.parameter("max-tilt", detection, &Detection::getMaximumTilt,
                    &Detection::setMaximumTilt, "degrees",
                    "largest angle of a plane with the horizontal",
                    Range::between(0, 45), degree);
  options.parameter("min-area", detection, &Detection::getMinimumArea,
                    &Detection::setMinimumArea, "m2", "smallest plane",
                    Range::above(0));
  options.text(
      "building", settings.building,
      "JSON file of pcl_room_segmentation: at which heights to look, and where a "
      "ceiling was hidden, points are added");
  options.flag("whole", settings.whole,
               "look at the file as a whole even if it has rooms");
  options.flag(
      "z-up", settings.trust_up,
      "take z as up even if another axis seems to be, or the scan is inclined");
  return runTool(options, argc, argv, [&] { return run(settings, detection); });
}
