// SPDX-License-Identifier: BSD-3-Clause
#include "building_file.h"

#include "tool_error.h"

#include "sedr_filters/src/plan/floorplan_format.h"

#include <fstream>

namespace pcl::sedr::tools {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* format_name = "sedr-building";
constexpr int format_version = 1;

Json
jsonOf(const BuildingRoom& room, const CellGrid& grid)
{
  Json hidden = Json::array();
  double floor = 0;
  for (const RoomColumn& column : room.columns) {
    floor += column.floor_seen ? 0 : grid.size() * grid.size();
    if (column.ceiling_seen)
      continue;
    const Eigen::Vector2d at = grid.centre(column.cell);
    hidden.push_back({at.x(), at.y(), column.ceiling});
  }
  return {{"id", room.id},
          {"storey", room.storey},
          {"area", room.area},
          {"floor", room.floor},
          {"ceiling", room.ceiling},
          {"enclosure", room.enclosure},
          {"inferred", room.inferred},
          {"unseen_outline", room.unseen_outline},
          {"hidden_floor_area", floor},
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
    RoomColumn column;
    column.cell = grid.at(at.x(), at.y());
    column.floor = static_cast<float>(room.floor);
    column.ceiling = static_cast<float>(at.z());
    column.ceiling_seen = false;
    room.columns.push_back(column);
  }
  return room;
}

Json
jsonOf(const LeftOut& thing)
{
  Json json{{"kind", nameOf(thing.kind)},
            {"reason", thing.reason},
            {"area", thing.area}};
  if (thing.kind == LeftOutKind::Void)
    return json; // all rooms together, without a position
  json["floor"] = thing.floor;
  json["ceiling"] = thing.ceiling;
  json["at"] = thing.at;
  return json;
}

Building
buildingFrom(const Json& json)
{
  if (json.value("format", "") != format_name ||
      json.value("version", 0) != format_version)
    throw ToolError("it is no building of pcl_room_segmentation");
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

} // namespace

const char*
nameOf(LeftOutKind kind)
{
  switch (kind) {
  case LeftOutKind::Low:
    return "no headroom";
  case LeftOutKind::Open:
    return "outdoors";
  case LeftOutKind::Partial:
    return "seen in part";
  case LeftOutKind::Landing:
    return "landing";
  case LeftOutKind::Mirror:
    return "mirror image";
  case LeftOutKind::Void:
    break;
  }
  return "void";
}

std::string
buildingToJson(const Building& building)
{
  Json rooms = Json::array();
  for (const BuildingRoom& room : building.rooms)
    rooms.push_back(jsonOf(room, building.grid));
  Json left_out = Json::array();
  for (const LeftOut& thing : building.left_out)
    left_out.push_back(jsonOf(thing));
  const Json json{{"format", format_name},
                  {"version", format_version},
                  {"unit", "m"},
                  {"cell_size", building.grid.size()},
                  {"seen_area", building.seen_area},
                  {"rooms", rooms},
                  {"storeys", building.storeys},
                  {"doorways", building.doorways},
                  {"stairs", building.stairs},
                  {"left_out", left_out}};
  return json.dump(1) + "\n";
}

Building
loadBuilding(const std::string& path)
{
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
    throw ToolError("'" + path + "' cannot be read");
  try {
    return buildingFrom(Json::parse(stream));
  }
  catch (const std::exception& error) {
    const std::string reason = error.what();
    const std::size_t name = reason.find("] "); // of an exception of nlohmann
    throw ToolError("'" + path + "' is no building: " +
                    reason.substr(name == std::string::npos ? 0 : name + 2));
  }
}

} // namespace pcl::sedr::tools
