// SPDX-License-Identifier: BSD-3-Clause
#include "bytes/whole_file.h"
#include "plan_file.h"
#include "rooms/labelled_rooms.h"
#include "run_tool.h"
#include "sedr_filters/src/base/number_text.h"
#include "stage_pictures.h"
#include "tool_error.h"

#include <pcl/sedr_filters/floorplan_io.h>
#include <pcl/sedr_segmentation/floorplan_fitting.h>

using namespace pcl::sedr::tools;
using pcl::sedr::StructureLabel;

namespace {

using Fitting = pcl::FloorplanFitting<pcl::PointXYZ>;

struct Settings {
  std::string input;
  std::string output;
  std::string raw;
  std::string building;
  PictureFile picture;
};

/** @brief Passes the points by label to the fitting, and rooms and owners if the file
 * has any. */
void
setEvidence(const ToolCloud& cloud, Fitting& fitting)
{
  fitting.setInputCloud(cloud.points);
  fitting.setCeilingIndices(requireLabel(cloud, StructureLabel::Ceiling));
  fitting.setFloorIndices(requireLabel(cloud, StructureLabel::Floor));
  fitting.setDetailIndices(cloud.withLabel(StructureLabel::Detail));
  fitting.setWallIndices(requireLabel(cloud, StructureLabel::Wall));
  if (hasRooms(cloud))
    fitting.setRooms(cloud.room);
  fitting.setOwners(ownersOf(cloud));
}

void
tell(const pcl::sedr::PlanRoom& room)
{
  std::size_t arcs = 0;
  for (const auto& element : room.boundary.elements)
    arcs += element.isArc() ? 1 : 0;
  say(pcl::sedr::formatText(
      "room %u: %zu segments and %zu arcs, %.2f m around, %.2f m2, %zu columns, "
      "%zu details",
      room.id, room.boundary.elements.size() - arcs, arcs, room.perimeter(),
      room.area(), room.columns.size(), room.details.size()));
}

int
run(const Settings& settings, Fitting& fitting)
{
  checkOutput(settings.output, "a floor plan", {".json"});
  settings.picture.check();
  const ToolCloud cloud = loadCloud(settings.input);
  pcl::sedr::Building building;
  if (!settings.building.empty())
    building = loadBuilding(settings.building);
  setEvidence(cloud, fitting);
  if (!settings.raw.empty()) {
    ScanSettings in_same_frame;
    in_same_frame.origin = cloud.origin;
    fitting.setRawCloud(loadCloud(settings.raw, in_same_frame).points);
  }
  pcl::sedr::PlanDocument document;
  document.origin = cloud.origin;
  pcl::sedr::Floorplan& plan = document.plan;
  {
    const Progress progress("fitting walls");
    if (!fitting.segment(plan))
      throw ToolError(fitting.getErrorMessage(), NothingFound);
  }
  if (!settings.building.empty())
    giveStoreys(building, plan);
  writeWhole(settings.output, documentToJson(document));
  settings.picture.write([&] { return drawPlan(plan, fitting.getBoundaries()); });
  for (const auto& warnings : {fitting.getWarnings(), doubtsOfRooms(building, plan)})
    for (const auto& warning : warnings)
      warn(sentenceOf(warning));
  for (const auto& room : plan.rooms)
    tell(room);
  return Done;
}

} // namespace

int
main(int argc, char** argv)
{
  Fitting fitting;
  fitting.setNumberOfThreads(0);
  Settings settings;
  Options options(
      "pcl_floorplan_fitting",
      "Fits the floor plan: the walls of every room as a closed loop of segments and "
      "arcs, its\n"
      "columns, its ceiling's details, and the planes of floors and ceilings.");
  options.file(
      "INPUT", settings.input,
      "PCD or PLY file with labels 1 ceiling, 2 floor, 3 wall, perhaps 4 detail, and "
      "rooms if several");
  options.file("OUTPUT.json", settings.output, "floor plan to write");
  options.parameter("distance", fitting, &Fitting::getDistanceThreshold,
                    &Fitting::setDistanceThreshold, "m",
                    "farthest a point is from its line or circle", Range::above(0));
  options.parameter("grid", fitting, &Fitting::getGridSize, &Fitting::setGridSize, "m",
                    "edge of a cell of the outline", Range::between(0.01, 1));
  options.text("raw", settings.raw,
               "PCD or PLY file of the scan before thinning, to fit the plan to");
  options.text("building", settings.building,
               "JSON file of pcl_room_segmentation: the plan gets its storeys "
               "and stairs, its doubts are told");
  settings.picture.declare(options);
  return runTool(options, argc, argv, [&] { return run(settings, fitting); });
}
