// SPDX-License-Identifier: BSD-3-Clause
#include "detail_rooms.h"

#include "file_rooms.h"
#include "labelled_points.h"
#include "tool_error.h"

#include "sedr_filters/src/base/plane_fit.h"
#include "sedr_segmentation/src/levels/horizontal_levels.h"

#include <string>
#include <utility>

namespace pcl::sedr::tools {

namespace {

/** @brief Returns the rooms with their ceilings. */
std::vector<DetailRoom>
roomsWithCeilings(const ToolCloud& cloud)
{
  const PointView points(*cloud.points);
  std::vector<DetailRoom> rooms;
  for (const auto id : ceilingRooms(cloud)) {
    DetailRoom room;
    room.id = id;
    for (const auto i : cloud.withLabel(StructureLabel::Ceiling)) {
      const auto at = static_cast<std::size_t>(i);
      if ((id == 0 || cloud.room[at] == id) && points.isFinite(at))
        room.ceilings.push_back(i);
    }
    if (room.ceilings.empty())
      throw ToolError("no ceiling point of room " + std::to_string(id) + " is finite",
                      NothingFound);
    rooms.push_back(std::move(room));
  }
  return rooms;
}

/** @brief Assigns each point to the room with the nearest ceiling in plan. */
void
shareOut(const ToolCloud& cloud, const CellGrid& grid, std::vector<DetailRoom>& rooms)
{
  const PointView points(*cloud.points);
  std::vector<CellSet> scopes;
  for (const auto& room : rooms)
    scopes.emplace_back(grid, points, room.ceilings);
  const RoomTerritory territory(grid, scopes);
  if (!territory.problem().empty())
    throw ToolError(territory.problem());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const std::int32_t at = territory.roomAt(points[i]);
    if (at < 0)
      continue;
    DetailRoom& room = rooms[static_cast<std::size_t>(at)];
    room.around.push_back(static_cast<pcl::index_t>(i));
    if (cloud.label[i] == static_cast<std::uint32_t>(StructureLabel::Floor))
      room.floors.push_back(static_cast<pcl::index_t>(i));
  }
}

/** @brief Returns the largest ceiling of the room; the others are classified again. */
pcl::Indices
mainCeiling(const ToolCloud& cloud,
            const DetailRoom& room,
            const RoomPlaneParameters& planes)
{
  const PointView points(*cloud.points);
  const PlanSlab slab = findSlab(points, room.ceilings, planes.tolerance,
                                 planes.maximum_tilt, planes.seed);
  return pointsOn(points, room.ceilings, slab, planes.tolerance);
}

/** @brief Returns the lowest floor level that covers at least a tenth of the ceilings,
 * as higher levels may be platforms or table tops. All floors if none is that large. */
pcl::Indices
mainFloor(const ToolCloud& cloud,
          const DetailRoom& room,
          const CellGrid& grid,
          const RoomPlaneParameters& planes)
{
  const PointView points(*cloud.points);
  const std::size_t cells = CellSet(grid, points, room.ceilings).size();
  LevelParameters parameters;
  parameters.tolerance = planes.tolerance;
  parameters.cell_size = grid.size();
  parameters.seed = planes.seed;
  parameters.minimum_area =
      0.1 * static_cast<double>(cells) * grid.size() * grid.size();
  const auto levels = findLevels(points, room.floors, parameters);
  return levels.empty()
             ? room.floors
             : pointsOn(points, room.floors, levels.front().slab, parameters.tolerance);
}

/** @brief Returns the rooms of a file with room numbers at ceilings at most. */
std::vector<DetailRoom>
sharedOutRooms(const ToolCloud& cloud,
               const CellGrid& grid,
               const RoomPlaneParameters& parameters)
{
  std::vector<DetailRoom> rooms = roomsWithCeilings(cloud);
  shareOut(cloud, grid, rooms);
  for (DetailRoom& room : rooms) {
    room.ceiling = mainCeiling(cloud, room, parameters);
    room.floor = mainFloor(cloud, room, grid, parameters);
  }
  return rooms;
}

/** @brief Returns the rooms of a file written by room segmentation, as in the chain. */
std::vector<DetailRoom>
partedRooms(const ToolCloud& cloud,
            const CellGrid& grid,
            const RoomPlaneParameters& parameters)
{
  const PointView points(*cloud.points);
  const std::vector<FileRoom> known = roomsOf(cloud);
  std::vector<DetailRoom> rooms;
  for (const FileRoom& of_file : known) {
    DetailRoom room;
    room.id = of_file.id;
    room.is_parted = true;
    room.ceilings = of_file.ceiling;
    room.ceiling =
        pointsOn(points, of_file.ceiling, ceilingOf(of_file, cloud, parameters),
                 parameters.tolerance);
    room.floors = of_file.floor;
    const CellSet scope(grid, points, of_file.ceiling);
    if (!room.floors.empty()) {
      const PlanSlab plane = floorOf(of_file, cloud, parameters);
      room.floor = pointsOn(points, room.floors, plane, parameters.tolerance);
      room.floor_height = plane.heightAt(grid.centre(scope[scope.size() / 2]));
    }
    rooms.push_back(std::move(room));
  }
  const auto at =
      territoryOf(known, cloud, grid.size()).roomsAt(points, parameters.threads);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (at[i] < 0)
      continue;
    DetailRoom& room = rooms[static_cast<std::size_t>(at[i])];
    room.around.push_back(static_cast<int>(i));
    if (cloud.room[i] == 0 &&
        cloud.label[i] == static_cast<std::uint32_t>(StructureLabel::Floor))
      room.floors.push_back(static_cast<int>(i)); // outside the rooms: objects
  }
  return rooms;
}

} // namespace

std::vector<DetailRoom>
detailRooms(const ToolCloud& cloud,
            double grid_size,
            const RoomPlaneParameters& parameters)
{
  const CellGrid grid(grid_size);
  return isByRooms(cloud) ? partedRooms(cloud, grid, parameters)
                          : sharedOutRooms(cloud, grid, parameters);
}

} // namespace pcl::sedr::tools
