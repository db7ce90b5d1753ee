// SPDX-License-Identifier: BSD-3-Clause
#include "labelled_rooms.h"

#include "tool_error.h"

#include "sedr_segmentation/src/plan/room_territory.h"
#include "sedr_segmentation/src/scan/scan_inclination.h"
#include <pcl/sedr_filters/impl/floor_recovery.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace pcl::sedr::tools {

namespace {

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
              const CellGrid& grid)
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
  throwProblem(territory.problem());
  return territory.roomsAt(points, 0);
}

} // namespace

pcl::Indices
requireLabel(const ToolCloud& cloud, StructureLabel label)
{
  pcl::Indices found = cloud.withLabel(label);
  if (found.empty())
    throw ToolError("none of the " + std::to_string(cloud.size()) + " points of '" +
                        cloud.path + "' has label " +
                        std::to_string(static_cast<std::uint32_t>(label)) + ", " +
                        pcl::sedr::toString(label),
                    NothingFound);
  return found;
}

double
meanFloorHeight(const ToolCloud& cloud)
{
  const PointView points(*cloud.points);
  pcl::Indices finite;
  for (const auto i : requireLabel(cloud, StructureLabel::Floor))
    if (points.isFinite(static_cast<std::size_t>(i)))
      finite.push_back(i);
  if (finite.empty())
    throw ToolError("none of the points of '" + cloud.path +
                        "' with label 2, floor, is finite",
                    NothingFound);
  return meanHeight(points, finite);
}

bool
hasRooms(const ToolCloud& cloud, StructureLabel label)
{
  const pcl::Indices rows = cloud.withLabel(label);
  return std::any_of(rows.begin(), rows.end(), [&](int i) {
    return cloud.room[static_cast<std::size_t>(i)] != 0;
  });
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

void
storeLabels(ToolCloud& cloud)
{
  setField(cloud.blob, "label", cloud.label);
  if (cloud.has_room)
    setField(cloud.blob, "room", cloud.room);
}

namespace {

/** @brief Gives floors without a room to the room with the lowest ceiling above. */
void
shareFloors(const ToolCloud& cloud,
            const CellGrid& grid,
            std::vector<LabelledRoom>& rooms)
{
  constexpr double noise = 0.15; // metres
  const PointView points(*cloud.points);
  std::vector<CellSet> scopes;
  std::vector<double> ceilings;
  for (const LabelledRoom& room : rooms) {
    scopes.push_back(unite(CellSet(grid, points, room.ceiling),
                           CellSet(grid, points, room.details)));
    ceilings.push_back(ceilingLevel(points, room.ceiling));
  }
  for (const int i : cloud.withLabel(StructureLabel::Floor)) {
    const auto at = static_cast<std::size_t>(i);
    const Eigen::Vector3f p = points[at];
    if (cloud.room[at] != 0 || !points.isFinite(at) || !grid.holds(p.x(), p.y()))
      continue;
    std::size_t lowest = rooms.size();
    for (std::size_t r = 0; r < rooms.size(); ++r)
      if (ceilings[r] >= p.z() - noise &&
          scopes[r].find(grid.at(p.x(), p.y())) != CellSet::npos &&
          (lowest == rooms.size() || ceilings[r] < ceilings[lowest]))
        lowest = r;
    if (lowest < rooms.size())
      rooms[lowest].floor.push_back(i);
  }
}

} // namespace

std::vector<LabelledRoom>
labelledRooms(const ToolCloud& cloud, double grid_size)
{
  const PointView points(*cloud.points);
  const bool has_rooms = hasRooms(cloud);
  std::map<std::uint32_t, LabelledRoom> by_number;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if ((has_rooms && cloud.room[i] == 0) || !points.isFinite(i))
      continue;
    LabelledRoom& room = by_number[has_rooms ? cloud.room[i] : 0];
    room.id = has_rooms ? cloud.room[i] : 0;
    const auto label = static_cast<StructureLabel>(cloud.label[i]);
    for (const auto& [own, rows] : {std::pair(StructureLabel::Ceiling, &room.ceiling),
                                    std::pair(StructureLabel::Floor, &room.floor),
                                    std::pair(StructureLabel::Detail, &room.details)})
      if (label == own)
        rows->push_back(static_cast<int>(i));
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
      territoriesOf(rooms, points, has_rooms && hasRooms(cloud, StructureLabel::Floor),
                    CellGrid(grid_size));
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (at[i] < 0)
      continue;
    LabelledRoom& room = rooms[static_cast<std::size_t>(at[i])];
    room.around.push_back(static_cast<int>(i));
    if (has_rooms && cloud.room[i] == 0 &&
        cloud.label[i] == static_cast<std::uint32_t>(StructureLabel::Detail))
      room.details.push_back(static_cast<int>(i));
  }
  if (has_rooms)
    shareFloors(cloud, CellGrid(grid_size), rooms);
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
checkScan(const ToolCloud& cloud,
          bool trust_up,
          RoomsAlongZ rooms,
          double found_area,
          const std::string& missing)
{
  const PointView points(*cloud.points);
  pcl::Indices all(cloud.size());
  std::iota(all.begin(), all.end(), 0);
  std::string doubt;
  if (rooms == RoomsAlongZ::NotLookedFor)
    doubt = scanProblem(points, all);
  if (doubt.empty() && !trust_up) {
    doubt = upProblem(points, all, rooms, found_area, 0);
    if (doubt.empty() && rooms != RoomsAlongZ::Found)
      doubt = inclinationProblem(points, all, 0);
    if (!doubt.empty())
      doubt += ", or say --z-up if it is right as it is";
  }
  if (!missing.empty())
    throw ToolError(missing + (doubt.empty() ? "" : "; " + doubt), NothingFound);
  if (!doubt.empty())
    throw ToolError("'" + cloud.path + "': " + doubt, NothingFound);
}

} // namespace pcl::sedr::tools
