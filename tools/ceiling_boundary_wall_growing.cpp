// SPDX-License-Identifier: BSD-3-Clause
#include "rooms/labelled_rooms.h"
#include "run_tool.h"
#include "stage_pictures.h"
#include "tool_error.h"

#include <pcl/sedr_segmentation/ceiling_boundary_wall_growing.h>

#include <algorithm>

using namespace pcl::sedr::tools;
using pcl::sedr::StructureLabel;

namespace {

using Growing = pcl::CeilingBoundaryWallGrowing<pcl::PointXYZ>;

pcl::Indices
growIn(const ToolCloud& cloud, const LabelledRoom& room, Growing& growing)
{
  double lowest = std::numeric_limits<double>::quiet_NaN(); // of the details
  for (const auto i : room.details)
    lowest = std::fmin(lowest, (*cloud.points)[static_cast<std::size_t>(i)].z);
  growing.setInputCloud(cloud.points);
  growing.setIndices(pcl::make_shared<const pcl::Indices>(room.around));
  growing.setCeilingIndices(room.ceiling);
  growing.setFloorIndices(room.floor);
  growing.setDetailIndices(room.details);
  growing.setSliceHeight(lowest);
  pcl::PointIndices walls_and_details;
  if (!growing.segment(walls_and_details))
    throw ToolError("room " + std::to_string(room.id) + ": " +
                        growing.getErrorMessage(),
                    NothingFound);
  return growing.getWallIndices();
}

int
run(const StageFiles& files, Growing& growing)
{
  constexpr double territory_cell = 0.05; // metres
  files.check();
  ToolCloud cloud = loadCloud(files.input);
  std::replace(cloud.label.begin(), cloud.label.end(),
               static_cast<std::uint32_t>(StructureLabel::Wall),
               static_cast<std::uint32_t>(StructureLabel::Other));
  const std::vector<LabelledRoom> rooms = labelledRooms(cloud, territory_cell);
  std::vector<pcl::Indices> found;
  {
    const Progress progress("growing walls");
    for (const LabelledRoom& room : rooms)
      found.push_back(growIn(cloud, room, growing));
  }
  std::size_t walls = 0;
  for (std::size_t r = 0; r < rooms.size(); ++r)
    for (const auto i : found[r]) {
      const auto at = static_cast<std::size_t>(i);
      if (cloud.label[at] != 0)
        continue;
      setLabel({i}, StructureLabel::Wall,
               rooms[r].id > 0 ? rooms[r].id : cloud.room[at], cloud);
      ++walls;
    }
  if (walls == 0)
    throw ToolError("no point of '" + cloud.path + "' is within " +
                        std::to_string(growing.getDistanceThreshold()) +
                        " m of the boundary of the ceiling in plan",
                    NothingFound);
  storeLabels(cloud);
  files.save(cloud);
  say(std::to_string(walls) + " of " + std::to_string(cloud.size()) +
      " points are walls, of " + std::to_string(rooms.size()) +
      (rooms.size() == 1 ? " room" : " rooms"));
  return Done;
}

} // namespace

int
main(int argc, char** argv)
{
  Growing growing;
  growing.setNumberOfThreads(0);
  StageFiles files;
  Options options(
      "pcl_ceiling_boundary_wall_growing",
      "Labels the walls of every room, label 3: points below the boundary of its "
      "ceiling, label 1.\nUses the floor, label 2, and details, label 4, where the "
      "file has them; walls already labelled are looked for anew.");
  files.declare(options, " with labels, and rooms if several");
  options.parameter("distance", growing, &Growing::getDistanceThreshold,
                    &Growing::setDistanceThreshold, "m",
                    "farthest a wall point is from the boundary in plan",
                    Range::above(0));
  options.parameter("angle", growing, &Growing::getAngleThreshold,
                    &Growing::setAngleThreshold, "degrees",
                    "widest gap between directions to the neighbors of an inner point",
                    Range::between(1, 359), M_PI / 180);
  return runTool(options, argc, argv, [&] { return run(files, growing); });
}
