// SPDX-License-Identifier: BSD-3-Clause
#include "floorplan_format.h"

#include "../base/number_text.h"
#include "../plan/plan_check.h"
#include <pcl/sedr_filters/floorplan_io.h>
#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <utility>

namespace pcl::sedr {

using Json = nlohmann::ordered_json;

namespace {

/** @brief Writes the facets of a ceiling, or else its details. */
Json
detailsToJson(const std::vector<PlanDetail>& details, bool facets = false)
{
  Json json = Json::array();
  for (const auto& detail : details)
    if (detail.is_facet == facets) {
      json.push_back(detail);
      if (facets)
        json.back()["slab"] = facetToJson(detail.slab);
    }
  return json;
}

Json
roomToJson(const PlanRoom& room, const std::vector<double>& thicknesses)
{
  const ClearHeight height = clearHeight(room);
  Json walls = room.boundary;
  for (std::size_t i = 0; i < walls.size(); ++i)
    if (thicknesses[i] > 0)
      walls[i]["thickness"] = thicknesses[i];
  Json json{
      {"id", room.id},
      {"area", room.area()},
      {"perimeter", room.perimeter()},
      {"height", height.usual},
      {"volume", volumeOf(room, height.mean)},
      {"floor", room.floor},
      {"ceiling", room.hasFacets() ? facetToJson(room.ceiling) : Json(room.ceiling)},
      {"boundary", walls},
      {"columns", room.columns},
      {"details", detailsToJson(room.details)},
      {"floor_details", detailsToJson(room.floor_details)},
      {"niches", room.niches}};
  if (room.hasFacets())
    json["facets"] = detailsToJson(room.details, true);
  return json;
}

} // namespace

void
from_json(const Json& json, PlanRoom& room)
{
  room.id = wholeFrom(json.at("id"), 1, "the id of a room");
  json.at("floor").get_to(room.floor);
  json.at("ceiling").get_to(room.ceiling);
  json.at("boundary").get_to(room.boundary);
  PartFields fields(json);
  fields.optional("columns", room.columns);
  fields.optional("facets", room.details);
  for (PlanDetail& facet : room.details)
    facet.is_facet = true;
  std::vector<PlanDetail> details;
  fields.optional("details", details);
  std::move(details.begin(), details.end(), std::back_inserter(room.details));
  fields.optional("floor_details", room.floor_details);
  fields.optional("niches", room.niches);
}

void
from_json(const Json& json, Floorplan& plan)
{
  if (json.at("format") != floorplan_format_name)
    throw std::invalid_argument("it is not a floor plan");
  const Json& version = json.at("version");
  if (!version.is_number_integer() || version < 1 || version > floorplan_format_version)
    throw std::invalid_argument(
        "it has version " + version.dump() + ", versions 1 to " +
        std::to_string(floorplan_format_version) + " can be read");
  if (json.value("unit", "m") != "m")
    throw std::invalid_argument("its unit is " + json["unit"].dump() +
                                ", only the metre, \"m\", can be read");
  json.at("rooms").get_to(plan.rooms);
  if (json.contains("storeys"))
    for (const Json& entry : json.at("storeys")) {
      plan.storeys.emplace_back();
      plan.storeys.back().number = static_cast<std::uint32_t>(plan.storeys.size());
      entry.get_to(plan.storeys.back());
    }
  PartFields fields(json);
  fields.optional("stairs", plan.stairs);
  fields.optional("openings", plan.openings);
  if (json.contains("doorways"))
    addDoorways(json.at("doorways"), plan);
  numberOpenings(plan);
  if (json.contains("names") && json["names"].is_object())
    for (const auto& [room, name] : json["names"].items()) {
      std::uint32_t id = 0;
      const char* const end = room.data() + room.size();
      const auto [read, problem] = std::from_chars(room.data(), end, id);
      PlanRoom* const named = findRoom(plan, id);
      if (problem == std::errc() && read == end && named && name.is_string())
        named->name = name.get<std::string>();
    }
}

// The file.

nlohmann::ordered_json
levellingToJson(const Levelling& levelling)
{
  constexpr double degrees = 180 / M_PI;
  Json rows = Json::array();
  for (int r = 0; r < 3; ++r)
    rows.push_back(Eigen::Vector3d(levelling.rotation.row(r)));
  return {{"angle", levelling.angle() * degrees},
          {"direction", levelling.direction() * degrees},
          {"rotation", rows},
          {"about", Eigen::Vector3d(levelling.about)}};
}

namespace {

Levelling
levellingFromJson(const Json& json)
{
  Levelling levelling;
  const Json& rows = json.at("rotation");
  for (int r = 0; r < 3; ++r)
    levelling.rotation.row(r) =
        rows.at(static_cast<std::size_t>(r)).get<Eigen::Vector3d>();
  json.at("about").get_to(levelling.about);
  return levelling;
}

/** @brief Returns the reason of an exception for readers: without the name and number
 * that begin those of nlohmann, "[json.exception.type_error.302] ". */
std::string
reasonOf(const std::exception& error)
{
  const std::string reason = error.what();
  return reason.rfind("[json.exception", 0) == 0 ? reason.substr(reason.find("] ") + 2)
                                                 : reason;
}

} // namespace

std::string
documentToJson(const PlanDocument& document)
{
  const Floorplan& plan = document.plan;
  Json rooms = Json::array();
  Json names = Json::object();
  const auto thicknesses = wallThicknesses(plan, document.max_wall);
  for (std::size_t r = 0; r < plan.rooms.size(); ++r) {
    rooms.push_back(roomToJson(plan.rooms[r], thicknesses[r]));
    if (!plan.rooms[r].name.empty())
      names[std::to_string(plan.rooms[r].id)] = plan.rooms[r].name;
  }
  Json json{{"format", floorplan_format_name},
            {"version", floorplan_format_version},
            {"unit", "m"},
            {"origin", document.origin.place},
            {"rooms", rooms},
            {"storeys", storeysOf(plan)},
            {"stairs", stairsToJson(plan)}};
  if (!plan.openings.empty()) {
    Floorplan numbered = plan;
    numberOpenings(numbered);
    json["openings"] = numbered.openings;
  }
  if (document.levelling)
    json["levelling"] = levellingToJson(*document.levelling);
  json["max_wall"] = document.max_wall;
  if (!document.scan.empty())
    json["scan"] = document.scan;
  if (!names.empty())
    json["names"] = names;
  // A name may contain any bytes; invalid UTF-8 becomes U+FFFD.
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

PlanDocument
documentFromJson(const std::string& text, std::string& problem)
{
  problem.clear();
  try {
    const Json json = Json::parse(text);
    PlanDocument document;
    json.get_to(document.plan);
    if (const std::string wrong = planProblem(document.plan); !wrong.empty())
      throw std::invalid_argument(wrong);
    PartFields fields(json);
    fields.optional("origin", document.origin.place);
    if (json.contains("levelling"))
      document.levelling = levellingFromJson(json["levelling"]);
    Priors priors;
    if (json.contains("max_wall"))
      problem = setPrior("max_wall", json["max_wall"].get<double>(), priors);
    document.max_wall = priors.max_wall;
    fields.optional("scan", document.scan);
    return problem.empty() ? document : PlanDocument();
  }
  catch (const std::exception& error) {
    problem = std::string("the floor plan cannot be read: ") + reasonOf(error);
    return {};
  }
}

std::string
floorplanToJson(const Floorplan& plan)
{
  return documentToJson({plan});
}

Floorplan
floorplanFromJson(const std::string& text, std::string& problem)
{
  return documentFromJson(text, problem).plan;
}

bool
readOrigin(const Json& json, Origin& origin)
{
  origin = {};
  if (!json.is_object() || !json.contains("origin"))
    return true;
  try {
    origin.place = json["origin"].get<Eigen::Vector3d>();
    return true;
  }
  catch (const std::exception&) {
    return false;
  }
}

} // namespace pcl::sedr
