// SPDX-License-Identifier: BSD-3-Clause
#include "bytes/whole_file.h"
#include "picture_file.h"
#include "plan_file.h"
#include "plane_picture.h"
#include "progress.h"
#include "rooms/building_file.h"
#include "rooms/planes_of_rooms.h"
#include "rooms/scan_problem.h"
#include "run_tool.h"
#include "tool_cloud.h"
#include "tool_error.h"

#include "sedr_segmentation/src/planes/plane_list.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace pcl::sedr::tools;
using pcl::sedr::LevelKind;
using pcl::sedr::RoomsAlongZ;
using pcl::sedr::StructureLabel;

namespace {

using Detection = pcl::HorizontalPlaneDetection<pcl::PointXYZ>;
using Planes = std::vector<pcl::HorizontalPlane>;

/** Radians. PCL's factor is slightly larger and would exceed a limit of 45 degrees. */
constexpr double degree = M_PI / 180;

struct Settings : StageFiles {
  std::string planes;
  std::string building;
  bool trust_up = false;
  bool whole = false;
};

/** @brief Labels ceilings and floors in a file with rooms; returns its planes. */
Planes
planesByRoom(const Settings& settings, const Detection& detection, ToolCloud& cloud)
{
  pcl::sedr::RoomPlaneParameters parameters;
  parameters.tolerance = detection.getDistanceThreshold();
  parameters.maximum_tilt = detection.getMaximumTilt();
  parameters.threads = detection.getNumberOfThreads();
  pcl::sedr::Building building;
  if (!settings.building.empty())
    building = loadBuilding(settings.building);
  return labelPlanesOfRooms(parameters, detection.getGridSize(), building, cloud);
}

/** @brief Labels ceilings and floors in a file without rooms; returns its planes. */
Planes
planesOfAll(const Settings& settings, Detection& detection, ToolCloud& cloud)
{
  if (!settings.building.empty())
    throw ToolError("--building is of no use without rooms, '" + settings.input +
                    "' is looked at as a whole");
  checkScan(cloud);
  checkUp(cloud, settings.trust_up);
  Planes planes;
  detection.setInputCloud(cloud.points);
  if (!detection.segment(planes))
    throw ToolError(detection.getErrorMessage(), NothingFound);
  for (auto& plane : planes) // tops of walls just below a ceiling
    if (plane.area < detection.getMinimumArea())
      plane.kind = LevelKind::Other;
  const std::string missing =
      pcl::sedr::missingKind(planes, detection.getMinimumRoomHeight());
  checkUp(cloud, settings.trust_up,
          missing.empty() ? RoomsAlongZ::Found : RoomsAlongZ::None,
          missing.empty() ? pcl::sedr::areaOfRooms(planes) : 0, missing);
  std::fill(cloud.label.begin(), cloud.label.end(), 0);
  for (const auto& plane : planes)
    if (plane.kind != LevelKind::Other)
      setLabel(plane.inliers.indices,
               plane.kind == LevelKind::Ceiling ? StructureLabel::Ceiling
                                                : StructureLabel::Floor,
               0, cloud);
  setField(cloud.blob, "label", cloud.label);
  if (cloud.has_room)
    setField(cloud.blob, "room", std::vector<std::uint32_t>(cloud.size(), 0));
  return planes;
}

void
savePlanes(const std::string& path, const Planes& planes)
{
  using Json = nlohmann::ordered_json;
  Json list = Json::array();
  for (const auto& plane : planes) {
    const Eigen::Vector4d& p = plane.slab.plane;
    list.push_back({{"kind", nameOf(plane.kind)},
                    {"coefficients", {p[0], p[1], p[2], p[3]}},
                    {"height", plane.height},
                    {"area", plane.area},
                    {"residual", plane.residual},
                    {"inliers", plane.inliers.indices.size()}});
  }
  const Json json{{"format", "sedr-planes"},
                  {"version", 1},
                  {"unit", "m"},
                  {"planes", list}};
  writeWhole(path, [&](std::ostream& stream) { stream << json.dump(1) << '\n'; });
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
  if (!settings.planes.empty())
    checkJsonOutput(settings.planes);
  ToolCloud cloud = loadCloud(settings.input);
  Planes planes;
  {
    const Progress progress("finding planes");
    planes = !settings.whole && isByRooms(cloud)
                 ? planesByRoom(settings, detection, cloud)
                 : planesOfAll(settings, detection, cloud);
  }
  settings.save(cloud);
  if (!settings.planes.empty())
    savePlanes(settings.planes, planes);
  if (!settings.picture.empty())
    savePicture(settings.picture, drawPlanes(planes, detection.getHeightHistogram(),
                                             pcl::sedr::PointView(*cloud.points),
                                             detection.getGridSize()));
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
  options.file("INPUT", settings.input, "PCD or PLY file, z up, metres");
  options.file("OUTPUT", settings.output, "PCD or PLY file to write");
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
  options.text("planes", settings.planes, "JSON file for the list of planes");
  options.flag(
      "z-up", settings.trust_up,
      "take z as up even if another axis seems to be, or the scan is inclined");
  settings.addOptions(options);
  return runTool(options, argc, argv, [&] { return run(settings, detection); });
}
