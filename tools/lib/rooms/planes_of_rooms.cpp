// SPDX-License-Identifier: BSD-3-Clause
#include "planes_of_rooms.h"

#include <algorithm>

namespace pcl::sedr::tools {

namespace {

/** @brief Returns a room of the building, null if it is unknown. */
const BuildingRoom*
knownRoom(const Building& building, std::uint32_t id)
{
  const auto found =
      std::find_if(building.rooms.begin(), building.rooms.end(),
                   [&](const BuildingRoom& room) { return room.id == id; });
  return found == building.rooms.end() ? nullptr : &*found;
}

void
addHiddenCeiling(const BuildingRoom& known,
                 const CellGrid& columns,
                 const LabelledRoom& room,
                 const PlanSlab& plane,
                 const CellGrid& grid,
                 ToolCloud& cloud)
{
  const CellSet seen(grid, PointView(*cloud.points), room.ceiling);
  std::vector<Eigen::Vector3f> places;
  for (const HiddenCeiling& hidden :
       hiddenCeiling(known.columns, columns, grid, seen, plane))
    places.push_back(hidden.at);
  const std::size_t before = cloud.size();
  const pcl::Indices sources(places.size(), room.ceiling.front());
  appendRows(cloud.blob, cloud.blob, sources);
  setCoordinates(cloud.blob, before, places);
  for (const auto& place : places)
    cloud.points->push_back({place.x(), place.y(), place.z()});
  cloud.label.resize(cloud.points->size(),
                     static_cast<std::uint32_t>(StructureLabel::Ceiling));
  cloud.room.resize(cloud.points->size(), room.id);
}

} // namespace

std::vector<pcl::HorizontalPlane>
labelPlanesOfRooms(const RoomPlaneParameters& parameters,
                   double grid_size,
                   const Building& building,
                   ToolCloud& cloud)
{
  const CellGrid grid(grid_size);
  const std::vector<LabelledRoom> rooms = labelledRooms(cloud, grid_size);
  std::fill(cloud.label.begin(), cloud.label.end(), 0);
  std::fill(cloud.room.begin(), cloud.room.end(), 0);
  std::vector<pcl::HorizontalPlane> planes;
  for (const LabelledRoom& room : rooms) {
    const BuildingRoom* const known = knownRoom(building, room.id);
    const auto add = [&](const pcl::Indices& sheet, LevelKind kind, double height) {
      const PointView points(*cloud.points);
      const PlanSlab plane = mainPlane(points, sheet, height, parameters);
      planes.push_back(listedPlane(kind, plane,
                                   pointsOn(points, sheet, plane, parameters.tolerance),
                                   points, grid));
      return plane;
    };
    const PointView points(*cloud.points);
    const PlanSlab ceiling =
        add(room.ceiling, LevelKind::Ceiling,
            known ? known->ceiling : ceilingLevel(points, room.ceiling));
    setLabel(room.ceiling, StructureLabel::Ceiling, room.id, cloud);
    if (!room.floor.empty()) {
      add(room.floor, LevelKind::Floor,
          known ? known->floor : floorLevel(points, room.floor));
      setLabel(planes.back().inliers.indices, StructureLabel::Floor, room.id, cloud);
    }
    if (known)
      addHiddenCeiling(*known, building.grid, room, ceiling, grid, cloud);
  }
  setField(cloud.blob, "label", cloud.label);
  setField(cloud.blob, "room", cloud.room);
  return planes;
}

} // namespace pcl::sedr::tools
