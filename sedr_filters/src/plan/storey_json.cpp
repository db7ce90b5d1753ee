// SPDX-License-Identifier: BSD-3-Clause
#include "floorplan_format.h"

#include "../base/number_text.h"
#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>

namespace pcl::sedr {
namespace {

using Json = nlohmann::ordered_json;
using Ids = std::set<std::uint32_t>;

Ids
idsOf(const Floorplan& plan)
{
  Ids ids;
  for (const PlanRoom& room : plan.rooms)
    ids.insert(room.id);
  return ids;
}

/** @brief Returns the rooms of a doorway or stair; 0 for those that do not exist. */
template <typename Link>
std::array<std::uint32_t, 2>
knownRooms(const Link& link, const Ids& ids)
{
  std::array<std::uint32_t, 2> rooms = link.rooms;
  for (std::uint32_t& room : rooms)
    room = ids.count(room) > 0 ? room : 0;
  return rooms;
}

bool
isNowhere(const std::array<std::uint32_t, 2>& rooms)
{
  return rooms[0] == rooms[1];
}

/** @brief Reads an integer of at least `least` that fits 32 bits. */
std::uint32_t
wholeFrom(const Json& json, std::uint32_t least, const char* what)
{
  constexpr std::uint64_t most = std::numeric_limits<std::uint32_t>::max();
  if (!json.is_number_unsigned() || json.get<std::uint64_t>() < least ||
      json.get<std::uint64_t>() > most)
    throw std::invalid_argument(std::string(what) + " is a whole number from " +
                                std::to_string(least) + " to " + std::to_string(most) +
                                ", not " + json.dump());
  return json.get<std::uint32_t>();
}

double
heightFrom(const Json& json, const char* what)
{
  const auto height = json.get<double>();
  if (!(std::abs(height) <= max_coordinate))
    throw std::invalid_argument(std::string(what) + " must lie within " +
                                numberText(max_coordinate) + " m, it is " +
                                numberText(height));
  return height;
}

/** @brief Reads the id of a room of the plan, or 0 where allowed. */
std::uint32_t
roomFrom(const Json& json, const Ids& ids, std::uint32_t least, const std::string& of)
{
  const std::uint32_t id = wholeFrom(json, least, "the id of a room");
  if (id != 0 && ids.count(id) == 0)
    throw std::invalid_argument(of + " names room " + std::to_string(id) +
                                ", which the plan does not have");
  return id;
}

PlanStorey
storeyFrom(const Json& json, std::size_t place, const Ids& ids, Ids& placed)
{
  PlanStorey storey;
  storey.number = static_cast<std::uint32_t>(place + 1);
  if (json.contains("number"))
    storey.number = wholeFrom(json.at("number"), 1, "the number of a storey");
  storey.name = json.contains("name") ? json.at("name").get<std::string>()
                                      : storeyName(storey.number);
  if (json.contains("floor"))
    storey.floor = heightFrom(json.at("floor"), "the floor of a storey");
  if (json.contains("ceiling"))
    storey.ceiling = heightFrom(json.at("ceiling"), "the ceiling of a storey");
  for (const Json& room : json.at("rooms")) {
    storey.rooms.push_back(roomFrom(room, ids, 1, "a storey"));
    if (!placed.insert(storey.rooms.back()).second)
      throw std::invalid_argument("room " + std::to_string(storey.rooms.back()) +
                                  " is listed twice in the storeys");
  }
  std::sort(storey.rooms.begin(), storey.rooms.end());
  return storey;
}

/** @brief Reads the rooms and heights of a doorway or stair.
 * @param what its name with article: "a doorway" */
template <typename Link>
void
readLink(const Json& json, const Ids& ids, const std::string& what, Link& link)
{
  const Json& rooms = json.at("rooms");
  if (!rooms.is_array() || rooms.size() != 2)
    throw std::invalid_argument(what + " has 2 rooms, not " + rooms.dump());
  for (std::size_t k = 0; k < 2; ++k)
    link.rooms[k] = roomFrom(rooms.at(k), ids, 0, what);
  if (isNowhere(link.rooms))
    throw std::invalid_argument(what + " leads from room " +
                                std::to_string(link.rooms[0]) + " to itself");
  link.bottom = heightFrom(json.at("bottom"), (what + "'s bottom").c_str());
  link.top = heightFrom(json.at("top"), (what + "'s top").c_str());
  if (link.top < link.bottom)
    throw std::invalid_argument(what +
                                "'s top must not be below its bottom, it is by " +
                                numberText(link.bottom - link.top) + " m");
}

} // namespace

nlohmann::ordered_json
storeysToJson(const Floorplan& plan)
{
  Json storeys = Json::array();
  for (const PlanStorey& storey : storeysOf(plan))
    storeys.push_back({{"number", storey.number},
                       {"name", storey.name},
                       {"floor", storey.floor},
                       {"ceiling", storey.ceiling},
                       {"rooms", storey.rooms}});
  return storeys;
}

nlohmann::ordered_json
doorwaysToJson(const Floorplan& plan)
{
  const Ids ids = idsOf(plan);
  Json doorways = Json::array();
  for (const PlanDoorway& doorway : plan.doorways)
    if (const auto rooms = knownRooms(doorway, ids); !isNowhere(rooms))
      doorways.push_back({{"rooms", rooms},
                          {"start", pointToJson(doorway.start)},
                          {"end", pointToJson(doorway.end)},
                          {"bottom", doorway.bottom},
                          {"top", doorway.top}});
  return doorways;
}

nlohmann::ordered_json
stairsToJson(const Floorplan& plan)
{
  const Ids ids = idsOf(plan);
  Json stairs = Json::array();
  for (const PlanStair& stair : plan.stairs)
    if (const auto rooms = knownRooms(stair, ids); !isNowhere(rooms))
      stairs.push_back({{"rooms", rooms},
                        {"at", pointToJson(stair.at)},
                        {"bottom", stair.bottom},
                        {"top", stair.top}});
  return stairs;
}

void
readStoreys(const nlohmann::ordered_json& json, Floorplan& plan)
{
  const Ids ids = idsOf(plan);
  if (json.contains("storeys")) {
    Ids placed;
    Ids numbers;
    for (const Json& storey : json.at("storeys")) {
      plan.storeys.push_back(storeyFrom(storey, plan.storeys.size(), ids, placed));
      if (!numbers.insert(plan.storeys.back().number).second)
        throw std::invalid_argument("two storeys have the number " +
                                    std::to_string(plan.storeys.back().number));
    }
  }
  if (json.contains("doorways"))
    for (const Json& entry : json.at("doorways")) {
      PlanDoorway doorway;
      readLink(entry, ids, "a doorway", doorway);
      doorway.start = pointFromJson(entry.at("start"));
      doorway.end = pointFromJson(entry.at("end"));
      plan.doorways.push_back(doorway);
    }
  if (json.contains("stairs"))
    for (const Json& entry : json.at("stairs")) {
      PlanStair stair;
      readLink(entry, ids, "stairs", stair);
      stair.at = pointFromJson(entry.at("at"));
      plan.stairs.push_back(stair);
    }
}

} // namespace pcl::sedr
