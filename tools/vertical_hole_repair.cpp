// SPDX-License-Identifier: BSD-3-Clause
#include "plan_file.h"
#include "run_tool.h"
#include "stage_pictures.h"
#include "tool_error.h"

#include <pcl/sedr_filters/vertical_hole_repair.h>

using namespace pcl::sedr::tools;

namespace {

using Repair = pcl::VerticalHoleRepair<pcl::PointXYZ>;

struct Settings : StageFiles {
  std::string plan;
  bool keep_openings = false;
};

/** @brief Replaces the cloud by the repaired one: the retained rows, then those that
 * fill holes.
 * @return number of rows that fill holes */
std::size_t
apply(const Repair& repair, ToolCloud& cloud)
{
  const pcl::Indices& sources = repair.getSourceIndices();
  const auto& points = repair.getSurfacePoints();
  pcl::Indices seen;
  std::vector<pcl::sedr::SurfacePoint> surface;
  for (std::size_t k = 0; k < sources.size(); ++k)
    if (sources[k] >= 0) {
      seen.push_back(sources[k]);
      surface.push_back(points[k]);
    }
  for (const auto k : repair.getRepairedIndices())
    surface.push_back(points[static_cast<std::size_t>(k)]);
  cloud.blob = selectRows(cloud.blob, seen);
  appendZeroRows(cloud.blob, surface.size() - seen.size());
  setSurfacePoints(cloud.blob, surface);
  return surface.size() - seen.size();
}

int
run(const Settings& settings, Repair& repair)
{
  settings.check();
  const auto plan = loadPlan(settings.plan).plan;
  ToolCloud cloud = loadCloud(settings.input);
  giveRooms(plan, cloud);
  {
    const Progress progress("filling holes");
    repair.setInputCloud(cloud.points);
    repair.setFloorplan(plan);
    repair.setKeepOpenings(settings.keep_openings);
    repair.setLabels(cloud.label);
    repair.setRooms(cloud.room);
    pcl::PointCloud<pcl::PointXYZ> whole;
    repair.filter(whole);
    throwProblem(repair.getErrorMessage(), NothingFound);
  }
  const std::size_t filled = apply(repair, cloud);
  settings.save(cloud);
  say(std::to_string(rowsOf(cloud.blob)) + " points, " + std::to_string(filled) +
      " of them fill holes");
  return Done;
}

} // namespace

int
main(int argc, char** argv)
{
  Repair repair;
  Settings settings;

  Options options("pcl_vertical_hole_repair",
                  "Fills the holes of a refined structure: one point for every cell of "
                  "every surface of the "
                  "plan,\nthe scanned one nearest to its middle or a new one there, at "
                  "the end of the file.");
  settings.declare(options, ", as pcl_structure_refinement writes it", &settings.plan);
  options.parameter("grid", repair, &Repair::getGridSize, &Repair::setGridSize, "m",
                    "edge of a cell", Range::between(0.01, 1));
  options.flag("keep-openings", settings.keep_openings,
               "fill no holes where the plan has doors, windows and passages");
  return runTool(options, argc, argv, [&] { return run(settings, repair); });
}
