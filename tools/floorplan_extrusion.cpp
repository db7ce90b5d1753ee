// SPDX-License-Identifier: BSD-3-Clause
#include "model/solid_files.h"
#include "plan_file.h"
#include "run_tool.h"
#include "sedr_filters/src/base/number_text.h"
#include "tool_cloud.h"
#include "tool_error.h"

#include <pcl/sedr_surface/floorplan_extrusion.h>

#include <iostream>

using namespace pcl::sedr::tools;

namespace {

using Extrusion = pcl::FloorplanExtrusion<pcl::PointXYZ>;

struct Settings {
  std::string plan;
  std::string output;
  std::string openings = "closed";
};

void
tell(const pcl::sedr::RoomSolidReport& report)
{
  say(pcl::sedr::formatText(
      "room %u: %zu triangles, floor %.2f m2, walls %.2f m2, %.2f m3, %s", report.room,
      report.triangles, report.floor_area, report.wall_area, report.volume,
      report.closed ? "closed" : report.problem.c_str()));
}

int
run(const Settings& settings, Extrusion& extrusion)
{
  checkSolidOutput(settings.output);
  const pcl::sedr::PlanDocument file = loadPlan(settings.plan);
  extrusion.setFloorplan(file.plan);
  extrusion.setCutOpenings(settings.openings == "cut");
  pcl::PolygonMesh unused;
  extrusion.reconstruct(unused);
  for (const auto& report : extrusion.getReports())
    tell(report);
  if (extrusion.getMesh().empty())
    throw ToolError(extrusion.getErrorMessage(), NothingFound);
  saveSolid(settings.output, extrusion.getMesh(), extrusion.getElements(), file.plan,
            file.origin);
  for (const auto& warning : extrusion.getWarnings())
    warn(sentenceOf(warning));
  if (!extrusion.getErrorMessage().empty())
    std::cerr << "pcl_floorplan_extrusion: " << extrusion.getErrorMessage() << '\n';
  return Done;
}

} // namespace

int
main(int argc, char** argv)
{
  Extrusion extrusion;
  Settings settings;
  Options options("pcl_floorplan_extrusion",
                  "Makes the sharp solid of a floor plan: one closed surface a room.");
  options.file("PLAN.json", settings.plan,
               "floor plan, as pcl_sedr and "
               "pcl_floorplan_fitting write it");
  options.file(
      "OUTPUT", settings.output,
      "solid to write: .ply, faces with room, label and element, or .obj with "
      "groups of element, room and storey and materials by label in a .mtl beside it, "
      "or .glb (glTF 2.0) for the web");
  options.text("openings", settings.openings,
               "doors and windows in the solid: closed, or cut with their reveals",
               {"closed", "cut"});
  return runTool(options, argc, argv, [&] { return run(settings, extrusion); });
}
