// SPDX-License-Identifier: BSD-3-Clause
#include "file_rooms.h"

#include "tool_error.h"

#include <algorithm>
#include <map>
#include <utility>

namespace pcl::sedr::tools {

namespace {

/** @brief Returns the height range of a room. */
RoomHeights
heightsOf(const FileRoom& room, const PointView& points)
{
  constexpr double headroom = 1.8; // metres, for a room whose floor was not seen
  std::vector<float> above;
  for (const auto* part : {&room.ceiling, &room.details})
    for (const int i : *part)
      above.push_back(points[static_cast<std::size_t>(i)].z());
  const double floor = room.floor.empty() && !above.empty()
                           ? *std::min_element(above.begin(), above.end()) - headroom
                           : floorLevel(points, room.floor);
  return heightsFrom(floor, std::move(above));
}

} // namespace

bool
isByRooms(const ToolCloud& cloud)
{
  const auto hasRoom = [&](StructureLabel label) {
    const pcl::Indices rows = cloud.withLabel(label);
    return std::any_of(rows.begin(), rows.end(), [&](int i) {
      return cloud.room[static_cast<std::size_t>(i)] != 0;
    });
  };
  return hasRoom(StructureLabel::Ceiling) && hasRoom(StructureLabel::Floor);
}

std::vector<FileRoom>
roomsOf(const ToolCloud& cloud)
{
  const PointView points(*cloud.points);
  std::map<std::uint32_t, FileRoom> by_number;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (cloud.room[i] == 0 || !points.isFinite(i))
      continue;
    FileRoom& room = by_number[cloud.room[i]];
    room.id = cloud.room[i];
    const auto label = static_cast<StructureLabel>(cloud.label[i]);
    if (label == StructureLabel::Ceiling)
      room.ceiling.push_back(static_cast<int>(i));
    else if (label == StructureLabel::Floor)
      room.floor.push_back(static_cast<int>(i));
    else if (label == StructureLabel::Detail)
      room.details.push_back(static_cast<int>(i));
  }
  std::vector<FileRoom> rooms;
  for (auto& entry : by_number)
    if (!entry.second.ceiling.empty())
      rooms.push_back(std::move(entry.second));
  return rooms;
}

PlanSlab
floorOf(const FileRoom& room,
        const ToolCloud& cloud,
        const RoomPlaneParameters& parameters)
{
  const PointView points(*cloud.points);
  return mainPlane(points, room.floor, floorLevel(points, room.floor), parameters);
}

PlanSlab
ceilingOf(const FileRoom& room,
          const ToolCloud& cloud,
          const RoomPlaneParameters& parameters)
{
  const PointView points(*cloud.points);
  return mainPlane(points, room.ceiling, ceilingLevel(points, room.ceiling),
                   parameters);
}

RoomTerritory
territoryOf(const std::vector<FileRoom>& rooms,
            const ToolCloud& cloud,
            double grid_size)
{
  const CellGrid grid(grid_size);
  const PointView points(*cloud.points);
  std::vector<CellSet> scopes;
  std::vector<RoomHeights> heights;
  for (const FileRoom& room : rooms) {
    pcl::Indices above = room.ceiling;
    above.insert(above.end(), room.details.begin(), room.details.end());
    scopes.emplace_back(grid, points, above);
    heights.push_back(heightsOf(room, points));
  }
  RoomTerritory territory(grid, scopes, heights);
  if (!territory.problem().empty())
    throw ToolError(territory.problem());
  return territory;
}

} // namespace pcl::sedr::tools
