// SPDX-License-Identifier: BSD-3-Clause
#include "floorplan_format.h"

#include <pcl/sedr_filters/floorplan_io.h>
#include <pcl/sedr_filters/plan_measures.h>

#include <nlohmann/json.hpp>

#include <algorithm>

namespace pcl::sedr {

namespace {

using Json = nlohmann::ordered_json;

Json
toJson(const PlanElement& e)
{
  Json json{{"type", e.isArc() ? "arc" : "segment"},
            {"start", pointToJson(e.start)},
            {"end", pointToJson(e.end)}};
  if (e.isArc()) {
    json["centre"] = pointToJson(e.centre);
    json["radius"] = e.radius;
    json["counter_clockwise"] = e.counter_clockwise;
  }
  json["inliers"] = e.inliers;
  json["residual"] = e.residual;
  if (e.evidence.isKnown())
    json["evidence"] = {{"seen", e.evidence.seen},
                        {"hidden", e.evidence.hidden},
                        {"opening", e.evidence.opening}};
  return json;
}

Json
toJson(const PlanLoop& loop)
{
  Json json = Json::array();
  for (const auto& e : loop.elements)
    json.push_back(toJson(e));
  return json;
}

Json
loopsToJson(const std::vector<PlanLoop>& loops)
{
  Json json = Json::array();
  for (const auto& loop : loops)
    json.push_back(toJson(loop));
  return json;
}

Json
toJson(const PlanSlab& slab)
{
  Json json{{"plane", {slab.plane[0], slab.plane[1], slab.plane[2], slab.plane[3]}},
            {"inliers", slab.inliers},
            {"residual", slab.residual}};
  if (slab.inferred > 0)
    json["inferred"] = slab.inferred;
  return json;
}

/** @brief Writes a slab with the fields that only facets have. */
Json
facetToJson(const PlanSlab& slab)
{
  Json json = toJson(slab);
  addCurveToJson(slab, json);
  return json;
}

/** @brief Writes the facets of a ceiling, or else its details. */
Json
detailsToJson(const std::vector<PlanDetail>& details, bool facets = false)
{
  Json json = Json::array();
  for (const auto& detail : details)
    if (detail.is_facet == facets)
      json.push_back({{"slab", facets ? facetToJson(detail.slab) : toJson(detail.slab)},
                      {"boundary", toJson(detail.boundary)},
                      {"holes", loopsToJson(detail.holes)}});
  return json;
}

/** @brief Writes the boundary of a room, with wall thicknesses where known. */
Json
wallsToJson(const Floorplan& plan, std::size_t room)
{
  Json walls = toJson(plan.rooms[room].boundary);
  for (std::size_t i = 0; i < walls.size(); ++i) {
    const double thickness = wallThickness(plan, room, i);
    if (thickness > 0)
      walls[i]["thickness"] = thickness;
  }
  return walls;
}

Json
toJson(const Floorplan& plan, std::size_t number)
{
  const PlanRoom& room = plan.rooms[number];
  const double height = meanHeight(room);
  Json niches = Json::array();
  for (const auto& niche : room.niches)
    niches.push_back({{"bottom", toJson(niche.bottom)},
                      {"top", toJson(niche.top)},
                      {"boundary", toJson(niche.boundary)}});
  Json json{
      {"id", room.id},
      {"area", room.area()},
      {"perimeter", room.perimeter()},
      {"height", height},
      {"volume", volumeOf(room, height)},
      {"floor", toJson(room.floor)},
      {"ceiling", room.hasFacets() ? facetToJson(room.ceiling) : toJson(room.ceiling)},
      {"boundary", wallsToJson(plan, number)},
      {"columns", loopsToJson(room.columns)},
      {"details", detailsToJson(room.details)},
      {"floor_details", detailsToJson(room.floor_details)},
      {"niches", niches}};
  if (room.hasFacets())
    json["facets"] = detailsToJson(room.details, true);
  return json;
}

int
versionOf(const Floorplan& plan)
{
  const bool has_facets =
      std::any_of(plan.rooms.begin(), plan.rooms.end(),
                  [](const PlanRoom& room) { return room.hasFacets(); });
  return has_facets ? floorplan_facets_version : floorplan_format_version;
}

} // namespace

nlohmann::ordered_json
levellingToJson(const Levelling& levelling)
{
  constexpr double degrees = 180 / M_PI;
  Json rows = Json::array();
  for (int r = 0; r < 3; ++r)
    rows.push_back(
        {levelling.rotation(r, 0), levelling.rotation(r, 1), levelling.rotation(r, 2)});
  return {{"angle", levelling.angle() * degrees},
          {"direction", levelling.direction() * degrees},
          {"rotation", rows},
          {"about", {levelling.about.x(), levelling.about.y(), levelling.about.z()}}};
}

nlohmann::ordered_json
pointToJson(const Eigen::Vector2d& p)
{
  return Json::array({p.x(), p.y()});
}

std::string
floorplanToJson(const Floorplan& plan,
                const Levelling* levelling,
                const Origin& origin,
                double max_wall)
{
  Json rooms = Json::array();
  for (std::size_t r = 0; r < plan.rooms.size(); ++r)
    rooms.push_back(toJson(plan, r));
  Json json{{"format", floorplan_format_name},
            {"version", versionOf(plan)},
            {"unit", "m"},
            {"origin", {origin.place.x(), origin.place.y(), origin.place.z()}},
            {"rooms", rooms},
            {"storeys", storeysToJson(plan)},
            {"doorways", doorwaysToJson(plan)},
            {"stairs", stairsToJson(plan)}};
  if (levelling)
    json["levelling"] = levellingToJson(*levelling);
  if (max_wall != Priors().max_wall)
    json["max_wall"] = max_wall;
  return json.dump(1) + "\n";
}

} // namespace pcl::sedr
