// SPDX-License-Identifier: BSD-3-Clause
#include "labelled_rooms.h"

#include "tool_error.h"

#include "sedr_segmentation/src/plan/room_territory.h"

#include <algorithm>
#include <map>
#include <utility>

namespace pcl::sedr::tools {

namespace {

/** @brief Returns the list of a room that holds rows with a label; null if none does.
 */
pcl::Indices*
listOf(StructureLabel label, LabelledRoom& room)
{
  switch (label) {
  case StructureLabel::Ceiling:
    return &room.ceiling;
  case StructureLabel::Floor:
    return &room.floor;
  case StructureLabel::Detail:
    return &room.details;
  default:
    return nullptr;
  }
}

bool
hasNumbers(const ToolCloud& cloud, StructureLabel label)
{
  const pcl::Indices rows = cloud.withLabel(label);
  return std::any_of(rows.begin(), rows.end(), [&](int i) {
    return cloud.room[static_cast<std::size_t>(i)] != 0;
  });
}

/** @brief Returns the height range of a room. */
RoomHeights
heightsOf(const LabelledRoom& room, const PointView& points)
{
  constexpr double headroom = 1.8; // metres, for a room whose floor was not seen
  std::vector<float> above;
  for (const auto* part : {&room.ceiling, &room.details})
    for (const int i : *part)
      above.push_back(points[static_cast<std::size_t>(i)].z());
  const double floor = room.floor.empty()
                           ? *std::min_element(above.begin(), above.end()) - headroom
                           : floorLevel(points, room.floor);
  return heightsFrom(floor, std::move(above));
}

/** @brief Returns the room of each row, by its place in `rooms`; -1 for none. */
std::vector<std::int32_t>
territoriesOf(const std::vector<LabelledRoom>& rooms,
              const PointView& points,
              bool lie_in_storeys,
              const CellGrid& grid,
              unsigned threads)
{
  std::vector<CellSet> scopes;
  std::vector<RoomHeights> heights;
  for (const LabelledRoom& room : rooms) {
    pcl::Indices above = room.ceiling;
    above.insert(above.end(), room.details.begin(), room.details.end());
    scopes.emplace_back(grid, points, above);
    if (lie_in_storeys)
      heights.push_back(heightsOf(room, points));
  }
  const RoomTerritory territory(grid, scopes, heights);
  if (!territory.problem().empty())
    throw ToolError(territory.problem());
  return territory.roomsAt(points, threads);
}

} // namespace

bool
isByRooms(const ToolCloud& cloud)
{
  return hasNumbers(cloud, StructureLabel::Ceiling) &&
         hasNumbers(cloud, StructureLabel::Floor);
}

std::vector<LabelledRoom>
labelledRooms(const ToolCloud& cloud, double grid_size, unsigned threads)
{
  const PointView points(*cloud.points);
  const bool has_rooms = hasNumbers(cloud, StructureLabel::Ceiling);
  std::map<std::uint32_t, LabelledRoom> by_number;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if ((has_rooms && cloud.room[i] == 0) || !points.isFinite(i))
      continue;
    LabelledRoom& room = by_number[has_rooms ? cloud.room[i] : 0];
    room.id = has_rooms ? cloud.room[i] : 0;
    if (auto* const list = listOf(static_cast<StructureLabel>(cloud.label[i]), room))
      list->push_back(static_cast<int>(i));
  }
  std::vector<LabelledRoom> rooms;
  for (auto& entry : by_number)
    if (!entry.second.ceiling.empty())
      rooms.push_back(std::move(entry.second));
  if (rooms.empty())
    throw ToolError("none of the " + std::to_string(cloud.size()) + " points of '" +
                        cloud.path + "' has label 1, ceiling, and is finite",
                    NothingFound);
  const auto at =
      territoriesOf(rooms, points, isByRooms(cloud), CellGrid(grid_size), threads);
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (at[i] < 0)
      continue;
    LabelledRoom& room = rooms[static_cast<std::size_t>(at[i])];
    room.around.push_back(static_cast<int>(i));
    if (has_rooms && cloud.room[i] == 0 &&
        cloud.label[i] == static_cast<std::uint32_t>(StructureLabel::Floor))
      room.floor.push_back(static_cast<int>(i));
  }
  return rooms;
}

PlanSlab
ceilingOf(const LabelledRoom& room,
          const ToolCloud& cloud,
          const RoomPlaneParameters& parameters)
{
  const PointView points(*cloud.points);
  return mainPlane(points, room.ceiling, ceilingLevel(points, room.ceiling),
                   parameters);
}

PlanSlab
floorOf(const LabelledRoom& room,
        const ToolCloud& cloud,
        const RoomPlaneParameters& parameters)
{
  const PointView points(*cloud.points);
  return mainPlane(points, room.floor, floorLevel(points, room.floor), parameters);
}

void
setLabel(const pcl::Indices& rows,
         StructureLabel label,
         std::uint32_t room,
         ToolCloud& cloud)
{
  for (const int i : rows) {
    cloud.label[static_cast<std::size_t>(i)] = static_cast<std::uint32_t>(label);
    cloud.room[static_cast<std::size_t>(i)] = room;
  }
}

} // namespace pcl::sedr::tools
