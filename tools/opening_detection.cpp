// SPDX-License-Identifier: BSD-3-Clause
#include "bytes/whole_file.h"
#include "plan_file.h"
#include "rooms/labelled_rooms.h"
#include "run_tool.h"
#include "sedr_filters/src/base/number_text.h"
#include "stage_pictures.h"
#include "tool_cloud.h"
#include "tool_error.h"

#include <pcl/sedr_filters/floorplan_io.h>
#include <pcl/sedr_filters/plan_measures.h>
#include <pcl/sedr_segmentation/opening_detection.h>

#include <algorithm>

using namespace pcl::sedr::tools;

namespace {

using Detection = pcl::OpeningDetection<pcl::PointXYZ>;

struct Settings {
  std::string scan;
  std::string plan;
  std::string output;
  std::string building;
  PictureFile picture;
};

/** @brief Warns if no room's outline was seen by a third: of four scans .53 to .95
 * were, with plans of other scans .21 at most. */
void
warnOfAnotherFrame(const pcl::sedr::Floorplan& plan)
{
  constexpr double min_share = 1.0 / 3;
  double most = 0;
  for (const pcl::sedr::PlanRoom& room : plan.rooms) {
    double seen = 0;
    for (const pcl::sedr::PlanElement& wall : room.boundary.elements)
      seen += wall.evidence.seen * wall.length();
    if (const double length = room.boundary.length(); length > 0)
      most = std::max(most, seen / length);
  }
  if (most < min_share)
    warn(pcl::sedr::formatText(
        "of no room's outline more than %.1f %% was seen: is the plan of this scan, in "
        "its frame and unit?",
        100 * most));
}

int
run(const Settings& settings, Detection& detection)
{
  checkOutput(settings.output, "a floor plan", {".json"});
  settings.picture.check();
  pcl::sedr::Building building;
  if (!settings.building.empty())
    building = loadBuilding(settings.building);
  pcl::sedr::PlanDocument file = loadPlan(settings.plan);
  pcl::sedr::Floorplan& plan = file.plan;
  ScanSettings in_same_frame;
  in_same_frame.origin = file.origin;
  detection.setInputCloud(loadCloud(settings.scan, in_same_frame).points);
  pcl::sedr::Priors priors;
  priors.max_wall = file.max_wall;
  detection.setPriors(priors);
  {
    const Progress progress("finding openings");
    if (!detection.segment(plan))
      throw ToolError(detection.getErrorMessage(), NothingFound);
  }
  writeWhole(settings.output, documentToJson(file));
  settings.picture.write([&] { return drawOpenings(plan, *detection.getSearch()); });
  warnOfAnotherFrame(plan);
  for (const auto& warning : linksWithoutOpening(building, plan))
    warn(sentenceOf(warning));
  for (const pcl::sedr::PlanOpening& opening : plan.openings)
    say(pcl::sedr::formatText(
        "%s between rooms %u and %u: %.2f x %.2f m, from z %.2f m",
        nameOf(opening.kind), opening.rooms[0], opening.rooms[1], opening.width(),
        opening.height(), opening.bottom));
  return Done;
}

} // namespace

int
main(int argc, char** argv)
{
  Detection detection;
  Settings settings;
  Options options("pcl_opening_detection",
                  "Finds the doors, windows, passages and niches of a floor plan in "
                  "its scan, and writes the\nplan with them.");
  options.file("SCAN", settings.scan, "scan before thinning, in the plan's frame");
  options.file("PLAN.json", settings.plan,
               "floor plan, as pcl_floorplan_fitting writes it");
  options.file("OUTPUT.json", settings.output, "floor plan to write");
  options.text("building", settings.building,
               "JSON file of pcl_room_segmentation: tells where one walks from room to "
               "room and no opening was found");
  settings.picture.declare(options);
  return runTool(options, argc, argv, [&] { return run(settings, detection); });
}
