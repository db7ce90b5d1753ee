// SPDX-License-Identifier: BSD-3-Clause
#include "rooms/labelled_rooms.h"
#include "run_tool.h"
#include "stage_pictures.h"
#include "tool_error.h"

#include <pcl/sedr_segmentation/horizontal_plane_detection.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>

using namespace pcl::sedr::tools;
using pcl::sedr::LevelKind;
using pcl::sedr::StructureLabel;

namespace {

using Detection = pcl::HorizontalPlaneDetection<pcl::PointXYZ>;
using Planes = std::vector<pcl::HorizontalPlane>;

/** Radians. PCL's factor is slightly larger and would exceed a limit of 45 degrees. */
constexpr double degree = M_PI / 180;

struct Settings : StageFiles {
  bool trust_up = false;
};

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

/** @brief Labels ceilings and floors; returns all planes. */
Planes
findPlanes(const Settings& settings, Detection& detection, ToolCloud& cloud)
{
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
    planes = findPlanes(settings, detection, cloud);
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
      "points of ceilings 1,\nof floors 2, all others 0. Rooms are set to 0.");
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
  options.flag(
      "z-up", settings.trust_up,
      "take z as up even if another axis seems to be, or the scan is inclined");
  return runTool(options, argc, argv, [&] { return run(settings, detection); });
}
