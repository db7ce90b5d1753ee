// SPDX-License-Identifier: BSD-3-Clause
#include "bytes/whole_file.h"
#include "plan_file.h"
#include "run_tool.h"
#include "tool_error.h"

#include <pcl/sedr_surface/floorplan_ifc.h>

using namespace pcl::sedr::tools;

namespace {

void
tell(const pcl::sedr::IfcModel& model)
{
  for (const auto& warning : model.warnings)
    warn(sentenceOf(warning));
  say(std::to_string(model.spaces) + " spaces, " + std::to_string(model.walls) +
      " walls, " + std::to_string(model.paired_walls) +
      " of them seen from both sides, " + std::to_string(model.slabs) + " slabs, " +
      std::to_string(model.columns) + " columns, " + std::to_string(model.openings) +
      " openings");
}

} // namespace

int
main(int argc, char** argv)
{
  std::string plan;
  std::string output;
  std::string arcs = "exact";
  std::string schedules;
  pcl::sedr::IfcSettings settings;
  Options options("pcl_floorplan_ifc", "Writes a floor plan as IFC4.");
  options.file("PLAN.json", plan,
               "floor plan, as pcl_sedr and pcl_floorplan_fitting write it");
  options.file("OUTPUT.ifc", output, "building model to write");
  options.text("ifc-arcs", arcs,
               "arcs of the IFC: exact, or faceted for programs that misread them",
               {"exact", "faceted"});
  options.words("project", settings.name,
                "name of project and building; GUIDs are made of it and of the scan");
  options.date("date", settings.date, "of the file");
  options.words("drawn-by", settings.author, "author of the file");
  options.text("schedules", schedules,
               "folder for rooms.csv, openings.csv and walls.csv; none: not written");
  options.words(
      "crs", settings.crs,
      "name of the grid that the coordinates are in, for the IFC: EPSG:25832");
  options.number("assumed-thickness", settings.assumed_thickness, "m",
                 "of walls and slabs of the IFC of which one face was seen",
                 Range::between(0.02, 2));
  return runTool(options, argc, argv, [&] {
    checkOutput(output, "a building model", {".ifc"});
    if (!schedules.empty())
      checkWritable(schedules + "/rooms.csv");
    const pcl::sedr::PlanDocument file = loadPlan(plan);
    settings.arcs =
        arcs == "faceted" ? pcl::sedr::IfcArcs::Facets : pcl::sedr::IfcArcs::Exact;
    settings.max_wall = file.max_wall;
    settings.scan = file.scan;
    const auto model = writeIfc(file.plan, settings, file.origin);
    writeWhole(output, model.text);
    if (!schedules.empty())
      for (const auto& table : tablesOf(model.schedules))
        writeWhole(schedules + "/" + table.name + ".csv", csvOf(table));
    tell(model);
    return Done;
  });
}
