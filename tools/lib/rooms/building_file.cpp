// SPDX-License-Identifier: BSD-3-Clause
#include "building_file.h"

#include "tool_error.h"

#include <nlohmann/json.hpp>

#include <array>
#include <fstream>

namespace pcl::sedr::tools {

namespace {

using Json = nlohmann::ordered_json;
using RoomPair = std::array<std::uint32_t, 2>;

constexpr const char* format_name = "sedr-building";
constexpr int format_version = 1;

Json
pairOf(const Eigen::Vector2d& p)
{
  return {p.x(), p.y()};
}

Eigen::Vector2d
placeOf(const Json& json)
{
  return {json.at(0).get<double>(), json.at(1).get<double>()};
}

double
heightOf(const Json& json, const char* name)
{
  return json.at(name).get<double>();
}

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
  room.id = json.at("id").get<std::uint32_t>();
  room.floor = heightOf(json, "floor");
  room.ceiling = heightOf(json, "ceiling");
  for (const Json& place : json.at("hidden_ceiling")) {
    const Eigen::Vector2d at = placeOf(place);
    if (!grid.holds(at.x(), at.y()))
      throw ToolError("a place of a hidden ceiling lies too far out");
    RoomColumn column;
    column.cell = grid.at(at.x(), at.y());
    column.floor = static_cast<float>(room.floor);
    column.ceiling = place.at(2).get<float>();
    column.ceiling_seen = false;
    room.columns.push_back(column);
  }
  return room;
}

Json
jsonOf(const PlanStorey& storey)
{
  return {{"number", storey.number},
          {"name", storey.name},
          {"floor", storey.floor},
          {"ceiling", storey.ceiling},
          {"rooms", storey.rooms}};
}

Json
jsonOf(const PlanDoorway& door)
{
  return {{"rooms", door.rooms},     {"start", pairOf(door.start)},
          {"end", pairOf(door.end)}, {"width", door.width()},
          {"bottom", door.bottom},   {"top", door.top}};
}

Json
jsonOf(const PlanStair& stair)
{
  return {{"rooms", stair.rooms},
          {"at", pairOf(stair.at)},
          {"bottom", stair.bottom},
          {"top", stair.top}};
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
  json["at"] = pairOf(thing.at);
  return json;
}

template <typename Thing>
Json
listOf(const std::vector<Thing>& things)
{
  Json list = Json::array();
  for (const Thing& thing : things)
    list.push_back(jsonOf(thing));
  return list;
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
  const CellGrid& grid = building.grid;
  for (const Json& room : json.at("rooms"))
    building.rooms.push_back(roomFrom(room, grid));
  for (const Json& storey : json.at("storeys"))
    building.storeys.push_back({storey.at("number").get<std::uint32_t>(),
                                storey.at("name").get<std::string>(),
                                heightOf(storey, "floor"), heightOf(storey, "ceiling"),
                                storey.at("rooms").get<std::vector<std::uint32_t>>()});
  for (const Json& door : json.at("doorways"))
    building.doorways.push_back({door.at("rooms").get<RoomPair>(),
                                 placeOf(door.at("start")), placeOf(door.at("end")),
                                 heightOf(door, "bottom"), heightOf(door, "top")});
  for (const Json& stair : json.at("stairs"))
    building.stairs.push_back({stair.at("rooms").get<RoomPair>(),
                               placeOf(stair.at("at")), heightOf(stair, "bottom"),
                               heightOf(stair, "top")});
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
  const CellGrid& grid = building.grid;
  Json rooms = Json::array();
  for (const BuildingRoom& room : building.rooms)
    rooms.push_back(jsonOf(room, grid));
  const Json json{{"format", format_name},
                  {"version", format_version},
                  {"unit", "m"},
                  {"cell_size", grid.size()},
                  {"seen_area", building.seen_area},
                  {"rooms", rooms},
                  {"storeys", listOf(building.storeys)},
                  {"doorways", listOf(building.doorways)},
                  {"stairs", listOf(building.stairs)},
                  {"left_out", listOf(building.left_out)}};
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
