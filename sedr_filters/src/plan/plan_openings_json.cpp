// SPDX-License-Identifier: BSD-3-Clause
#include "floorplan_format.h"

#include <algorithm>
#include <array>

namespace pcl::sedr {
namespace {

using Json = nlohmann::ordered_json;

// In the order of their enumerations.
constexpr std::array<const char*, 4> kinds{"unknown", "door", "window", "passage"};
constexpr std::array<const char*, 3> hinges{"unknown", "start", "end"};
constexpr std::array<const char*, 4> states{"unknown", "closed", "ajar", "open"};

template <typename Enum, std::size_t n>
void
readName(const Json& json,
         const char* what,
         const std::array<const char*, n>& names,
         Enum& value)
{
  if (!json.contains(what))
    return;
  const auto found = std::find(names.begin(), names.end(), json.at(what));
  if (found == names.end())
    throw std::invalid_argument(std::string("the ") + what +
                                " of an opening is not known: " + json.at(what).dump());
  value = static_cast<Enum>(found - names.begin());
}

} // namespace

const char*
nameOf(OpeningKind kind)
{
  return kinds[static_cast<std::size_t>(kind)];
}

void
to_json(Json& json, const PlanOpening& opening)
{
  Json walls = Json::array();
  for (const OpeningWall& wall : opening.walls)
    walls.push_back({{"room", wall.room}, {"element", wall.element}});
  Json head{{"shape", opening.rise > 0 ? "arched" : "flat"}};
  if (opening.rise > 0)
    head["rise"] = opening.rise;
  json = {{"kind", nameOf(opening.kind)},
          {"rooms", opening.rooms},
          {"walls", walls},
          {"start", opening.start},
          {"end", opening.end},
          {"bottom", opening.bottom},
          {"top", opening.top},
          {"width", opening.width()},
          {"height", opening.height()},
          {"head", head},
          {"depth", opening.depth},
          {"hinge", hinges[static_cast<std::size_t>(opening.hinge)]},
          {"swing", opening.swing},
          {"state", states[static_cast<std::size_t>(opening.state)]},
          {"confidence", opening.confidence},
          {"residual", opening.residual}};
}

void
from_json(const Json& json, PlanOpening& opening)
{
  readName(json, "kind", kinds, opening.kind);
  readName(json, "hinge", hinges, opening.hinge);
  readName(json, "state", states, opening.state);
  json.at("rooms").get_to(opening.rooms);
  for (const Json& wall : json.at("walls"))
    opening.walls.push_back({wall.at("room").get<std::uint32_t>(),
                             wall.at("element").get<std::size_t>()});
  json.at("start").get_to(opening.start);
  json.at("end").get_to(opening.end);
  json.at("bottom").get_to(opening.bottom);
  json.at("top").get_to(opening.top);
  opening.rise = json.value("head", Json::object()).value("rise", 0.0);
  opening.depth = json.value("depth", 0.0);
  opening.swing = json.value("swing", 0U);
  opening.confidence = json.value("confidence", 0.0);
  opening.residual = json.value("residual", 0.0);
}

} // namespace pcl::sedr
