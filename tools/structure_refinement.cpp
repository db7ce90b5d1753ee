// SPDX-License-Identifier: BSD-3-Clause
#include "picture_file.h"
#include "plan_file.h"
#include "run_tool.h"
#include "tool_error.h"

#include <pcl/sedr_filters/structure_refinement.h>

#include <algorithm>

using namespace pcl::sedr::tools;

namespace {

using Refinement = pcl::StructureRefinement<pcl::PointXYZ>;

/** Of five scans .75 to .94 of the points lie there, with plans of others .20 at most.
 */
constexpr double min_share = 0.5;

struct Settings : StageFiles {
  std::string plan;
};

int
run(const Settings& settings, Refinement& refinement)
{
  settings.check();
  const auto plan = loadPlan(settings.plan).plan;
  ToolCloud cloud = loadCloud(settings.input);
  giveRooms(plan, cloud);
  pcl::PointCloud<pcl::PointXYZ> refined;
  {
    const Progress progress("moving points onto the plan");
    refinement.setInputCloud(cloud.points);
    refinement.setFloorplan(plan);
    refinement.setLabels(cloud.label);
    refinement.setRooms(cloud.room);
    refinement.filter(refined);
    throwProblem(refinement.getErrorMessage(), NothingFound);
  }
  const auto labelled =
      cloud.size() -
      static_cast<std::size_t>(std::count(cloud.label.begin(), cloud.label.end(), 0));
  requireOneFrame(static_cast<double>(refined.size()) / static_cast<double>(labelled),
                  min_share, "of the labelled points lie at the plan's surfaces");
  cloud.blob = selectRows(cloud.blob, refinement.getSourceIndices());
  setSurfacePoints(cloud.blob, refinement.getSurfacePoints());
  settings.save(cloud);
  say(std::to_string(refined.size()) + " of " + std::to_string(labelled) +
      " labelled points are on the plan's surfaces");
  return Done;
}

} // namespace

int
main(int argc, char** argv)
{
  Refinement refinement;
  refinement.setNumberOfThreads(0);
  Settings settings;
  Options options("pcl_structure_refinement",
                  "Moves labelled points onto the planes, lines and arcs of a floor "
                  "plan, and sets their "
                  "normals\ninto the room, labels and rooms. Points that belong to no "
                  "surface are left out.");
  settings.declare(options, " with labels, and rooms if the plan has several",
                   &settings.plan);
  options.parameter("max-distance", refinement, &Refinement::getMaximumDistance,
                    &Refinement::setMaximumDistance, "m",
                    "the farthest a point may move; others are left out",
                    Range::above(0));
  return runTool(options, argc, argv, [&] { return run(settings, refinement); });
}
