// SPDX-License-Identifier: BSD-3-Clause
#include "plan_file.h"
#include "run_tool.h"
#include "stage_pictures.h"
#include "tool_error.h"

#include "sedr_filters/src/base/number_text.h"

#include <pcl/sedr_filters/structure_refinement.h>

#include <algorithm>
#include <set>

using namespace pcl::sedr::tools;

namespace {

using Refinement = pcl::StructureRefinement<pcl::PointXYZ>;

/** @brief Throws ToolError if less than half of the labelled points of the plan's rooms
 * lie at its surfaces: of five scans .75 to .94 do within 0.15 m, with plans of other
 * scans .20 at most. */
void
requireOneFrame(const pcl::sedr::Floorplan& plan,
                const ToolCloud& cloud,
                const Refinement& refinement)
{
  constexpr double min_share = 0.5;
  constexpr double usual_distance = 0.15; // metres
  std::set<std::uint32_t> rooms;
  for (const pcl::sedr::PlanRoom& room : plan.rooms)
    rooms.insert(room.id);
  std::size_t labelled = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    labelled += cloud.label[i] != 0 && rooms.count(cloud.room[i]) > 0;
  const double share = static_cast<double>(refinement.getSourceIndices().size()) /
                       static_cast<double>(std::max<std::size_t>(labelled, 1));
  if (refinement.getMaximumDistance() >= usual_distance && share < min_share)
    throw ToolError(pcl::sedr::formatText(
                        "%.1f %% of the labelled points lie at the plan's surfaces, at "
                        "least %.0f %% are needed: the plan is of another scan, or in "
                        "another frame or unit",
                        100 * share, 100 * min_share),
                    NothingFound);
}

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
  requireOneFrame(plan, cloud, refinement);
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
