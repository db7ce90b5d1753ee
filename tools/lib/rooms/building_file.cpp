// SPDX-License-Identifier: BSD-3-Clause
#include "building_file.h"

#include "tool_error.h"

#include "sedr_filters/src/json/floorplan_format.h"

#include <fstream>

namespace pcl::sedr::tools {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* format_name = "sedr-building";
constexpr int format_version = 2;

Json
jsonOf(const BuildingRoom& room, const CellGrid& grid)
{
  Json hidden = Json::array();
  for (const RoomColumn& column : room.columns)
    if (const Eigen::Vector2d at = grid.centre(column.cell); !column.ceiling_seen)
      hidden.push_back({at.x(), at.y(), column.ceiling});
  return {{"id", room.id},
          {"floor", room.floor},
          {"ceiling", room.ceiling},
          {"hidden_ceiling", hidden}};
}

BuildingRoom
roomFrom(const Json& json, const CellGrid& grid)
{
  BuildingRoom room;
  json.at("id").get_to(room.id);
  json.at("floor").get_to(room.floor);
  json.at("ceiling").get_to(room.ceiling);
  for (const Json& place : json.at("hidden_ceiling")) {
    const auto at = place.get<Eigen::Vector3d>();
    if (!grid.holds(at.x(), at.y()))
      throw ToolError("a place of a hidden ceiling lies too far out");
    room.columns.push_back({grid.at(at.x(), at.y()), static_cast<float>(room.floor),
                            static_cast<float>(at.z()), true, false});
  }
  return room;
}

} // namespace

std::string
buildingToJson(const Building& building)
{
  Json rooms = Json::array();
  for (const BuildingRoom& room : building.rooms)
    rooms.push_back(jsonOf(room, building.grid));
  return Json{{"format", format_name},
              {"version", format_version},
              {"unit", "m"},
              {"cell_size", building.grid.size()},
              {"rooms", rooms},
              {"storeys", building.storeys},
              {"doorways", building.doorways},
              {"stairs", building.stairs}}
             .dump(1) +
         "\n";
}

Building
loadBuilding(const std::string& path)
{
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
    throw ToolError("'" + path + "' cannot be read");
  try {
    const Json json = Json::parse(stream);
    if (json.value("format", "") != format_name ||
        json.value("version", 0) != format_version)
      throw ToolError("it is none that this pcl_room_segmentation writes");
    Building building;
    building.grid = CellGrid(json.at("cell_size").get<double>());
    if (!(building.grid.size() > 0))
      throw ToolError("its cells have no size");
    for (const Json& room : json.at("rooms"))
      building.rooms.push_back(roomFrom(room, building.grid));
    json.at("storeys").get_to(building.storeys);
    json.at("doorways").get_to(building.doorways);
    json.at("stairs").get_to(building.stairs);
    return building;
  }
  catch (const std::exception& error) {
    const std::string reason = error.what();
    const std::size_t name = reason.find("] "); // of an exception of nlohmann
    throw ToolError("'" + path + "' is no building: " +
                    reason.substr(name == std::string::npos ? 0 : name + 2));
  }
}

} // namespace pcl::sedr::tools
