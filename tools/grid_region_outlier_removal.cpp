// SPDX-License-Identifier: BSD-3-Clause
#include "rooms/labelled_rooms.h"
#include "run_tool.h"
#include "stage_pictures.h"
#include "tool_error.h"

#include <pcl/sedr_filters/grid_region_outlier_removal.h>

#include <numeric>

using namespace pcl::sedr::tools;
using pcl::sedr::StructureLabel;

namespace {

using Removal = pcl::GridRegionOutlierRemoval<pcl::PointXYZ>;

struct Settings : StageFiles {
  unsigned int label = static_cast<unsigned int>(StructureLabel::Ceiling);
  bool remove = false;
};

/** @brief Writes the result to the fields of the cloud. */
void
apply(const Settings& settings,
      const pcl::Indices& selected,
      const Removal& removal,
      ToolCloud& cloud)
{
  const bool numbers_rooms =
      settings.label == static_cast<unsigned int>(StructureLabel::Ceiling);
  const auto& regions = removal.getRegionLabels();
  std::vector<bool> rejected(cloud.size(), false);
  for (const auto index : selected) {
    const auto i = static_cast<std::size_t>(index);
    rejected[i] = regions[i] == 0;
    cloud.label[i] = rejected[i] ? 0 : settings.label;
    if (numbers_rooms)
      cloud.room[i] = static_cast<std::uint32_t>(regions[i]);
  }
  cloud.has_room = cloud.has_room || numbers_rooms;
  storeLabels(cloud);
  pcl::Indices stay;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (!rejected[i])
      stay.push_back(static_cast<pcl::index_t>(i));
  if (settings.remove)
    cloud.blob = selectRows(cloud.blob, stay);
}

int
run(const Settings& settings, Removal& removal)
{
  settings.check();
  ToolCloud cloud = loadCloud(settings.input);
  pcl::Indices selected(cloud.size());
  std::iota(selected.begin(), selected.end(), 0);
  if (cloud.has_label)
    selected = requireLabel(cloud, static_cast<StructureLabel>(settings.label));
  pcl::Indices kept;
  {
    const Progress progress("labelling regions");
    removal.setInputCloud(cloud.points);
    removal.setIndices(pcl::make_shared<const pcl::Indices>(selected));
    removal.filter(kept);
  }
  throwProblem(removal.getErrorMessage());
  if (kept.empty())
    throw ToolError("none of the " + std::to_string(selected.size()) +
                        " points is finite, there is no region",
                    NothingFound);
  apply(settings, selected, removal, cloud);
  settings.save(cloud);
  say(std::to_string(kept.size()) + " of " + std::to_string(selected.size()) +
      " points in " + std::to_string(removal.getNumberOfRegions()) + " of " +
      std::to_string(removal.getRegionSizes().size()) + " regions, threshold " +
      std::to_string(removal.getThreshold()) + " cells");
  return Done;
}

} // namespace

int
main(int argc, char** argv)
{
  Removal removal(true);
  Settings settings;
  Options options(
      "pcl_grid_region_outlier_removal",
      "Removes points outside the large regions of a plan, and numbers the regions of "
      "ceilings as rooms.\nWorks on the points with one label; on all points of a file "
      "without labels.");
  settings.declare(options, "");
  options.number("label", settings.label, "",
                 "label of the points to work on, 1 ceiling, 2 floor");
  options.parameter("grid", removal, &Removal::getGridSize, &Removal::setGridSize, "m",
                    "edge of a cell", Range::above(0));
  options.flag("remove", settings.remove,
               "leave rejected points out, instead of label 0");
  return runTool(options, argc, argv, [&] { return run(settings, removal); });
}
