// SPDX-License-Identifier: BSD-3-Clause
#include "rooms/labelled_rooms.h"
#include "run_tool.h"
#include "stage_pictures.h"
#include "tool_error.h"

#include <pcl/sedr_filters/floor_projection_recovery.h>

#include <algorithm>
#include <optional>

using namespace pcl::sedr::tools;
using pcl::sedr::StructureLabel;

namespace {

using Recovery = pcl::FloorProjectionRecovery<pcl::PointXYZ>;

struct Settings : StageFiles {
  double grid = Recovery().getGridSize();
  bool remove = false;
};

/** @brief The recovered floors of all rooms. */
struct Recovered {
  pcl::Indices removed; ///< rows of the input
  pcl::Indices sources; ///< rows that the new floor points copy
  std::vector<Eigen::Vector3f> points;
  std::vector<std::uint32_t> rooms;
};

/** @brief Projects to the plane of the room's own floor; without one, to the mean of
 * its floor, or of all floors where its own was hidden. */
void
recoverRoom(const Settings& settings,
            const ToolCloud& cloud,
            const LabelledRoom& room,
            const std::optional<pcl::sedr::PlanSlab>& own,
            Recovered& result)
{
  Recovery recovery(true);
  recovery.setInputCloud(cloud.points);
  recovery.setIndices(pcl::make_shared<const pcl::Indices>(room.floor));
  recovery.setCeilingIndices(room.ceiling);
  recovery.setDetailIndices(room.details);
  recovery.setGridSize(settings.grid);
  const auto projectTo = [&](const Eigen::Vector4d& plane) {
    const auto coefficients = pcl::make_shared<pcl::ModelCoefficients>();
    for (int k = 0; k < 4; ++k)
      coefficients->values.push_back(static_cast<float>(plane[k]));
    recovery.setFloorCoefficients(coefficients);
  };
  if (own)
    projectTo(own->plane);
  pcl::PointCloud<pcl::PointXYZ> floor;
  recovery.filter(floor);
  if (!recovery.getErrorMessage().empty() && !own) {
    projectTo({0, 0, 1, -meanFloorHeight(cloud)});
    recovery.filter(floor);
  }
  throwProblem(recovery.getErrorMessage());
  const pcl::Indices& removed = *recovery.getRemovedIndices();
  result.removed.insert(result.removed.end(), removed.begin(), removed.end());
  for (std::size_t i = floor.size() - recovery.getNumberOfProjected(); i < floor.size();
       ++i) {
    result.sources.push_back(recovery.getProjectedIndices()[i]);
    result.points.push_back(floor[i].getVector3fMap());
    result.rooms.push_back(room.id);
  }
}

/** @brief Writes the recovered points to the fields and rows of the cloud. */
void
apply(const Settings& settings, const Recovered& result, ToolCloud& cloud)
{
  const std::size_t before = cloud.size();
  std::vector<bool> stays(before + result.points.size(), true);
  for (const int i : result.removed) {
    setLabel({i}, StructureLabel::Other, 0, cloud);
    stays[static_cast<std::size_t>(i)] = !settings.remove;
  }
  cloud.label.resize(stays.size(), static_cast<std::uint32_t>(StructureLabel::Floor));
  cloud.room.insert(cloud.room.end(), result.rooms.begin(), result.rooms.end());
  cloud.blob += selectRows(cloud.blob, result.sources);
  setCoordinates(cloud.blob, before, result.points);
  setField(cloud.blob, "label", cloud.label);
  setField(cloud.blob, "room", cloud.room);
  for (const char* name : {"normal_x", "normal_y", "normal_z"}) {
    auto values = floatField(cloud.blob, name);
    if (values.empty())
      continue;
    std::fill(values.begin() + static_cast<std::ptrdiff_t>(before), values.end(),
              name[7] == 'z' ? 1.f : 0.f);
    setField(cloud.blob, name, values);
  }
  pcl::Indices stay;
  for (std::size_t i = 0; i < stays.size(); ++i)
    if (stays[i])
      stay.push_back(static_cast<pcl::index_t>(i));
  if (settings.remove)
    cloud.blob = selectRows(cloud.blob, stay);
}

int
run(const Settings& settings)
{
  settings.check();
  ToolCloud cloud = loadCloud(settings.input);
  const pcl::Indices labelled = requireLabel(cloud, StructureLabel::Floor);
  const bool is_numbered = hasRooms(cloud) && hasRooms(cloud, StructureLabel::Floor);
  Recovered result;
  {
    const Progress progress("completing the floor");
    std::vector<bool> is_inside(cloud.size(), false);
    for (const LabelledRoom& room : labelledRooms(cloud, settings.grid)) {
      std::optional<pcl::sedr::PlanSlab> own;
      if (is_numbered && !room.floor.empty() &&
          cloud.room[static_cast<std::size_t>(room.floor.front())] == room.id)
        own = floorOf(room, cloud, {});
      recoverRoom(settings, cloud, room, own, result);
      for (const auto* part : {&room.floor, &room.details})
        for (const int i : *part) {
          is_inside[static_cast<std::size_t>(i)] = true;
          cloud.room[static_cast<std::size_t>(i)] = room.id;
        }
    }
    for (const int i : labelled)
      if (!is_inside[static_cast<std::size_t>(i)])
        result.removed.push_back(i);
  }
  apply(settings, result, cloud);
  settings.save(cloud);
  say(std::to_string(result.points.size()) + " points projected, " +
      std::to_string(result.removed.size()) + " floor points removed");
  return Done;
}

} // namespace

int
main(int argc, char** argv)
{
  Settings settings;
  Options options(
      "pcl_floor_projection_recovery",
      "Completes the floor (label 2) from the ceiling and its details (labels 1 and 4) "
      "room by\nroom, and takes floor points outside the rooms for other (label 0).");
  settings.declare(options, " with field 'label', perhaps 'room'");
  options.number("grid", settings.grid, "m", "edge of a cell", Range::above(0));
  options.flag("remove", settings.remove, "leave floor points outside the rooms out");
  return runTool(options, argc, argv, [&] { return run(settings); });
}
