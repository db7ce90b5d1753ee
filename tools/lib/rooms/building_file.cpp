// SPDX-License-Identifier: BSD-3-Clause
#include "building_file.h"

#include "sedr_filters/src/json/floorplan_format.h"
#include "tool_error.h"

#include <array>
#include <cmath>
#include <fstream>

namespace pcl::sedr::tools {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* format_name = "sedr-building";
constexpr int format_version = 6;
constexpr int oldest_version = 5; ///< without doubts

/** @brief Returns the gaps of a room: runs along x of equal ones. Each is x and y of
 * its first cell, its number of cells, the heights of floor and ceiling, to a tenth of
 * a millimetre, and 1 if the floor was seen, 2 more if the ceiling was. */
Json
gapsOf(const BuildingRoom& room)
{
  const auto heights = [](const RoomColumn& column) {
    return std::array<double, 2>{std::round(1e4 * column.floor) / 1e4,
                                 std::round(1e4 * column.ceiling) / 1e4};
  };
  const auto seen = [](const RoomColumn& column) {
    return (column.floor_seen ? 1 : 0) + (column.ceiling_seen ? 2 : 0);
  };
  Json runs = Json::array();
  for (auto first = room.columns.begin(), end = first; first != room.columns.end();
       first = end) {
    for (++end; end != room.columns.end() &&
                end->cell == Cell{first->cell.x + static_cast<int>(end - first),
                                  first->cell.y} &&
                heights(*end) == heights(*first) && seen(*end) == seen(*first);)
      ++end;
    const auto [floor, ceiling] = heights(*first);
    runs.push_back(
        {first->cell.x, first->cell.y, end - first, floor, ceiling, seen(*first)});
  }
  return runs;
}

} // namespace

std::string
buildingToJson(const Building& building)
{
  Json rooms = Json::array();
  for (const BuildingRoom& room : building.rooms)
    rooms.push_back({{"id", room.id},
                     {"floor", room.floor},
                     {"ceiling", room.ceiling},
                     {"gaps", gapsOf(room)}});
  Json links = Json::array();
  for (const RoomLink& link : building.links)
    links.push_back({{"rooms", link.rooms},
                     {"start", link.start},
                     {"end", link.end},
                     {"bottom", link.bottom},
                     {"top", link.top}});
  Json doubts = Json::array();
  for (const RoomDoubt& doubt : building.doubts)
    doubts.push_back({{"rooms", doubt.rooms},
                      {"at", doubt.at},
                      {"area", doubt.area},
                      {"chance", doubt.chance}});
  return Json{{"format", format_name},
              {"version", format_version},
              {"unit", "m"},
              {"grid",
               {{"cell", building.grid.size()},
                {"origin", building.frame.origin},
                {"yaw", building.frame.yaw()}}},
              {"rooms", rooms},
              {"storeys", building.storeys},
              {"links", links},
              {"stairs", building.stairs},
              {"doubts", doubts}}
             .dump() +
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
    if (json.value("format", "") != format_name)
      throw ToolError("its format is not " + std::string(format_name));
    const int version = json.value("version", 0);
    if (version < oldest_version || version > format_version)
      throw ToolError("its version is " + std::to_string(version) + ", and versions " +
                      std::to_string(oldest_version) + " to " +
                      std::to_string(format_version) + " are read");
    Building building;
    for (const Json& of_room : json.at("rooms")) {
      BuildingRoom& room = building.rooms.emplace_back();
      of_room.at("id").get_to(room.id);
      of_room.at("floor").get_to(room.floor);
      of_room.at("ceiling").get_to(room.ceiling);
    }
    json.at("storeys").get_to(building.storeys);
    for (const Json& of_link : json.at("links")) {
      RoomLink& link = building.links.emplace_back();
      of_link.at("rooms").get_to(link.rooms);
      of_link.at("start").get_to(link.start);
      of_link.at("end").get_to(link.end);
      of_link.at("bottom").get_to(link.bottom);
      of_link.at("top").get_to(link.top);
    }
    json.at("stairs").get_to(building.stairs);
    for (const Json& of_doubt : json.value("doubts", Json::array())) {
      RoomDoubt& doubt = building.doubts.emplace_back();
      of_doubt.at("rooms").get_to(doubt.rooms);
      of_doubt.at("at").get_to(doubt.at);
      of_doubt.at("area").get_to(doubt.area);
      of_doubt.at("chance").get_to(doubt.chance);
    }
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
