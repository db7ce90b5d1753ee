// SPDX-License-Identifier: BSD-3-Clause
#include "rooms/labelled_rooms.h"
#include "run_tool.h"
#include "sedr_filters/src/base/number_text.h"
#include "stage_pictures.h"
#include "tool_error.h"

#include <pcl/sedr_segmentation/grid_slice_detail.h>

#include <algorithm>

using namespace pcl::sedr::tools;
using pcl::sedr::StructureLabel;

namespace {

using Analysis = pcl::GridSliceDetail<pcl::PointXYZ>;

/** @brief The main ceiling and floor of a room, and its details. */
struct FoundDetails {
  pcl::Indices ceiling;
  pcl::Indices floor;
  pcl::Indices details;
};

FoundDetails
analyse(const ToolCloud& cloud, const LabelledRoom& room, Analysis& analysis)
{
  const pcl::sedr::PointView points(*cloud.points);
  pcl::sedr::RoomPlaneParameters parameters;
  parameters.tolerance = analysis.getDistanceThreshold();
  FoundDetails found;
  found.ceiling = pointsOn(points, room.ceiling, ceilingOf(room, cloud, parameters),
                           parameters.tolerance);
  double height = 0;
  if (room.floor.empty())
    height = meanFloorHeight(cloud);
  else {
    const pcl::sedr::PlanSlab plane = floorOf(room, cloud, parameters);
    found.floor = pointsOn(points, room.floor, plane, parameters.tolerance);
    const pcl::sedr::CellGrid grid(analysis.getGridSize());
    const pcl::sedr::CellSet scope(grid, points, room.ceiling);
    height = plane.heightAt(grid.centre(scope[scope.size() / 2]));
  }
  analysis.setInputCloud(cloud.points);
  analysis.setIndices(pcl::make_shared<const pcl::Indices>(room.around));
  analysis.setCeilingIndices(found.ceiling);
  analysis.setFloorIndices(found.floor);
  analysis.setFloorHeight(height);
  pcl::PointIndices details;
  if (!analysis.segment(details))
    throw ToolError("room " + std::to_string(room.id) + ": " +
                        analysis.getErrorMessage(),
                    NothingFound);
  found.details = details.indices;
  return found;
}

void
tell(const Analysis& analysis, const LabelledRoom& room, const FoundDetails& found)
{
  using pcl::sedr::formatText;
  if (found.details.empty())
    say(formatText("room %u: no details", room.id));
  else
    say(formatText("room %u: %zu points of details: %zu, all above %.2f m; trial %d",
                   room.id, found.details.size(), analysis.getRegionSizes().size(),
                   analysis.getSliceHeight(), analysis.getTrial()));
}

int
run(const StageFiles& files, Analysis& analysis)
{
  files.check();
  ToolCloud cloud = loadCloud(files.input);
  std::replace(cloud.label.begin(), cloud.label.end(),
               static_cast<std::uint32_t>(StructureLabel::Detail),
               static_cast<std::uint32_t>(StructureLabel::Other));
  const std::vector<LabelledRoom> rooms = labelledRooms(cloud, analysis.getGridSize());
  requireLabel(cloud, StructureLabel::Floor);
  std::vector<FoundDetails> found;
  {
    const Progress progress("looking at slices");
    for (const LabelledRoom& room : rooms) {
      found.push_back(analyse(cloud, room, analysis));
      tell(analysis, room, found.back());
    }
  }
  for (std::size_t r = 0; r < rooms.size(); ++r) { // other ceilings are details
    setLabel(rooms[r].ceiling, StructureLabel::Detail, rooms[r].id, cloud);
    setLabel(rooms[r].floor, StructureLabel::Other, 0, cloud);
    setLabel(found[r].floor, StructureLabel::Floor, rooms[r].id, cloud);
    setLabel(found[r].ceiling, StructureLabel::Ceiling, rooms[r].id, cloud);
    setLabel(found[r].details, StructureLabel::Detail, rooms[r].id, cloud);
  }
  storeLabels(cloud);
  files.save(cloud);
  return Done;
}

} // namespace

int
main(int argc, char** argv)
{
  Analysis analysis;
  analysis.setNumberOfThreads(0);
  StageFiles files;
  Options options(
      "pcl_grid_slice_detail",
      "Labels the details of every room's ceiling, soffits, beams and recesses, label "
      "4.\nUses ceilings, label 1, and floors, label 2; details already labelled are "
      "looked for anew.\nOf several ceilings of a room the largest keeps label 1, the "
      "others become details; of several\nfloors the lowest that a tenth of their "
      "points have keeps label 2, the others become 0.");
  files.declare(options, " with labels, and rooms if several");
  options.parameter("grid", analysis, &Analysis::getGridSize, &Analysis::setGridSize,
                    "m", "edge of a cell", Range::between(0.01, 1));
  options.parameter("distance", analysis, &Analysis::getDistanceThreshold,
                    &Analysis::setDistanceThreshold, "m",
                    "farthest a point is from the plane of the ceiling",
                    Range::above(0));
  options.parameter("min-cells", analysis, &Analysis::getMinimumCells,
                    &Analysis::setMinimumCells, "cells", "smallest detail");
  return runTool(options, argc, argv, [&] { return run(files, analysis); });
}
